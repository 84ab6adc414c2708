#include "gpu/Renderer.h"

#include "core/Assert.h"
#include "frame/IdColour.h"
#include "gpu/SceneCheck.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <optional>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr std::size_t kStorageBindings = layout::kBindVertices + 1;
// What an empty array is bound as: a range may not be empty.
constexpr std::size_t kSmallestRange = 256;

// The bindings whose contents change with every frame, in the order they are written.
constexpr std::array<std::uint32_t, 8> kFrameBindings{
    layout::kBindFrame,    layout::kBindBlocks, layout::kBindVisits, layout::kBindOwnership,
    layout::kBindClipSets, layout::kBindSky,    layout::kBindMovers, layout::kBindMoverMembers};

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& array) {
    return std::as_bytes(std::span(array));
}

// The plan's arrays, in the order of kFrameBindings.
std::array<std::span<const std::byte>, kFrameBindings.size()>
frameArrays(const frame::FramePlan& plan, const layout::FrameConstants& constants) {
    return {std::as_bytes(std::span(&constants, 1)),
            bytesOf(plan.blocks),
            bytesOf(plan.visits),
            bytesOf(plan.ownershipVertices),
            bytesOf(plan.clipSets),
            bytesOf(plan.skyInstances),
            bytesOf(plan.movers),
            bytesOf(plan.moverMembers)};
}

void copyTo(std::span<std::byte> ring, std::size_t offset, std::span<const std::byte> bytes) {
    if (!bytes.empty()) {
        std::memcpy(ring.data() + offset, bytes.data(), bytes.size());
    }
}

// A plan that breaks these would make the GPU read astray or loop.
void assertSound(const frame::FramePlan& plan) {
    LIMEN_ASSERT(!plan.visits.empty() && plan.visits.size() == plan.constants.visitCount,
                 "the root is a visit");
    LIMEN_ASSERT(!plan.blocks.empty(), "at least the eye's block is resident");
    for (std::size_t i = 0; i < plan.visits.size(); ++i) {
        const std::uint32_t parent = plan.visits[i].parent;
        LIMEN_ASSERT(parent == layout::kNoVisit || parent < i, "parents come before children");
    }
    for (const frame::Batch& batch : plan.batches) {
        const std::size_t size =
            batch.program == frame::Program::Ownership ? plan.ownershipVertices.size() : plan.commands.size();
        LIMEN_ASSERT(batch.program == frame::Program::SkyPlain ||
                         std::uint64_t{batch.firstCommand} + batch.commandCount <= size,
                     "a batch lies within its commands");
    }
    for (const frame::Stage& stage : plan.stages) {
        LIMEN_ASSERT(std::uint64_t{stage.firstBatch} + stage.batchCount <= plan.batches.size(),
                     "a stage lies within the batches");
    }
}

class Stopwatch {
public:
    [[nodiscard]] double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

SceneBindings bindingsOf(const frame::SceneUpload& upload, const TextureStore& textures) {
    std::vector<std::uint32_t> meshes, terrain;
    for (const layout::Material& material : upload.materials) {
        meshes.push_back(material.texture);
    }
    const auto addLayer = [&](const layout::TerrainLayer& layer) {
        if (layer.texture != layout::kNoTexture) {
            terrain.insert(terrain.end(), {layer.texture, layer.alpha});
        }
    };
    for (const layout::TerrainCell& cell : upload.terrainCells) {
        terrain.push_back(cell.base.texture);
        std::for_each(std::begin(cell.overlays), std::end(cell.overlays), addLayer);
        std::for_each(std::begin(cell.roads), std::end(cell.roads), addLayer);
    }
    return {textures.bindingFor(meshes), textures.bindingFor(terrain)};
}

std::vector<std::string> definesOf(const RendererOptions& options) {
    std::vector<std::string> defines = options.shaderDefines;
    if (options.exactOutlines) {
        defines.emplace_back("EXACT_OUTLINES");
    }
    return defines;
}

bool isFlat(const RenderOptions& options) {
    return options.shading != Shading::Lit;
}

// Flat frames show ids, and neither what is blended nor what floats in the sky has one. Frames that count layers paint
// nothing blended.
bool isSkipped(frame::Program program, const RenderOptions& options) {
    return (program == frame::Program::SkyObjects && (isFlat(options) || options.wantLayers)) ||
           (program == frame::Program::Blended && isFlat(options) && !options.wantLayers);
}

glm::vec4 clearColour(const frame::FramePlan& plan, const RenderOptions& options) {
    if (!isFlat(options)) {
        return plan.constants.voidColour;
    }
    const auto [r, g, b] = frame::colourOfId(layout::kVoidId);
    return glm::vec4(r, g, b, 255) / 255.0f;
}

ProgramVariant variantOf(const frame::Batch& batch, const RenderOptions& options, bool multisampled) {
    return {batch.gated, batch.program == frame::Program::Blended ? options.wantLayers : isFlat(options),
            multisampled};
}

bool isOneDraw(frame::Program program) {
    return program == frame::Program::Ownership || program == frame::Program::SkyPlain;
}

} // namespace

struct Renderer::Scene {
    Scene(Device& device, TextureStore&& textureStore, Programs&& programSet)
        : device_(device), textures(std::move(textureStore)), programs(std::move(programSet)) {
        storage.fill(StorageRange{});
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() {
        for (BufferHandle buffer : owned) {
            device_.destroyBuffer(buffer);
        }
    }

    BufferHandle add(std::string_view label, std::span<const std::byte> bytes) {
        std::vector<std::byte> padded;
        if (bytes.size() < kSmallestRange) {
            padded.assign(bytes.begin(), bytes.end());
            padded.resize(kSmallestRange);
            bytes = padded;
        }
        owned.push_back(device_.createBuffer(label, bytes));
        return owned.back();
    }
    void addStorage(std::uint32_t binding, std::string_view label, std::span<const std::byte> bytes) {
        storage[binding] = {add(label, bytes), 0, std::max(bytes.size(), kSmallestRange)};
    }

    Device& device_;
    TextureStore textures;
    Programs programs;
    std::vector<BufferHandle> owned;
    std::array<StorageRange, kStorageBindings> storage;
    BufferHandle vertices = BufferHandle::Invalid, indices = BufferHandle::Invalid; ///< what draws read
};

struct Renderer::RingLayout {
    std::array<std::size_t, kFrameBindings.size()> offsets{}, sizes{};
    std::size_t commands = 0; ///< offset of the draw commands
    std::size_t total = 0;
};

Renderer::Renderer(Device& device, RendererOptions options) : device_(&device), options_(options) {}

Renderer::~Renderer() = default;

Result<void> Renderer::upload(const frame::SceneUpload& upload) {
    if (Result<void> checked = checkScene(upload); !checked) {
        return checked;
    }
    Result<TextureStore> textures = TextureStore::create(*device_, upload.textures, options_.textures);
    if (!textures) {
        return tl::unexpected(textures.error());
    }
    Result<Programs> programs =
        Programs::create(*device_, bindingsOf(upload, *textures), definesOf(options_));
    if (!programs) {
        return tl::unexpected(programs.error());
    }
    scene_ = std::make_unique<Scene>(*device_, std::move(*textures), std::move(*programs));
    scene_->addStorage(layout::kBindInstances, "instances", bytesOf(upload.instances));
    scene_->addStorage(layout::kBindMembers, "members", bytesOf(upload.members));
    scene_->addStorage(layout::kBindMaterials, "materials", bytesOf(upload.materials));
    scene_->addStorage(layout::kBindMaterialRefs, "material references", bytesOf(upload.materialRefs));
    scene_->addStorage(layout::kBindTerrain, "terrain cells", bytesOf(upload.terrainCells));
    scene_->addStorage(layout::kBindLightSets, "light sets", bytesOf(upload.lightSets));
    scene_->addStorage(layout::kBindLights, "lights", bytesOf(upload.lights));
    scene_->addStorage(layout::kBindTextures, "texture references", std::as_bytes(scene_->textures.refs()));
    scene_->vertices = scene_->add("vertices", bytesOf(upload.vertices));
    scene_->storage[layout::kBindVertices] = {scene_->vertices, 0,
                                              std::max(bytesOf(upload.vertices).size(), kSmallestRange)};
    scene_->indices = scene_->add("indices", bytesOf(upload.indices));
    return {};
}

Renderer::RingLayout Renderer::layOutRing(const frame::FramePlan& plan) const {
    const std::size_t alignment = device_->capabilities().storageAlignment;
    const auto arrays = frameArrays(plan, plan.constants);
    RingLayout ring;
    const auto place = [&](std::size_t size) {
        const std::size_t offset = (ring.total + alignment - 1) / alignment * alignment;
        ring.total = offset + size;
        return offset;
    };
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        ring.sizes[i] = std::max(arrays[i].size(), kSmallestRange);
        ring.offsets[i] = place(ring.sizes[i]);
    }
    ring.commands = place(bytesOf(plan.commands).size());
    return ring;
}

Result<void> Renderer::preparePrograms(const frame::FramePlan& plan, const RenderOptions& options,
                                       bool multisampled) {
    Result<void> prepared;
    for (const frame::Batch& batch : plan.batches) {
        if (prepared && !isSkipped(batch.program, options)) {
            prepared = scene_->programs.prepare(batch.program, variantOf(batch, options, multisampled));
        }
    }
    return prepared;
}

void Renderer::bindAll(const RingLayout& ring) {
    std::array<StorageRange, kStorageBindings> storage = scene_->storage;
    for (std::size_t i = 0; i < kFrameBindings.size(); ++i) {
        storage[kFrameBindings[i]] = {BufferHandle::Invalid, ring.offsets[i], ring.sizes[i]};
    }
    device_->bindStorage(storage);
    device_->bindTextures(scene_->textures.pages());
}

void Renderer::clearTarget(const frame::FramePlan& plan, const RenderOptions& options) {
    device_->clear(TargetImage::Ownership, std::uint32_t{0}); // the root visit's number
    if (options.shading != Shading::IdsOnly) {
        device_->clear(TargetImage::Colour, clearColour(plan, options));
    }
    if (options.wantLayers) {
        device_->clear(TargetImage::Layers, glm::vec4(0.0f));
    }
    if (options.wantIds) {
        device_->clear(TargetImage::Id, std::uint32_t{layout::kVoidId});
    }
    device_->clear(TargetImage::Depth, 0.0f);
}

void Renderer::drawBatch(const frame::Batch& batch, std::size_t commandsOffset, const RenderOptions& options,
                         bool multisampled) {
    DrawState state;
    state.program = scene_->programs.get(batch.program, variantOf(batch, options, multisampled));
    state.cullBackFaces =
        batch.program != frame::Program::Ownership; // a portal polygon counts from either side
    state.writeDepth = batch.program != frame::Program::Blended;
    device_->setState(state);
    switch (batch.program) {
    case frame::Program::Ownership:
        device_->drawVertices(batch.firstCommand, batch.commandCount);
        return;
    case frame::Program::SkyPlain:
        device_->drawVertices(0, batch.commandCount > 0 ? 3 : 0);
        return;
    default:
        device_->drawIndirect(commandsOffset + std::size_t{batch.firstCommand} * sizeof(layout::DrawCommand),
                              batch.commandCount);
    }
}

void Renderer::drawStages(const frame::FramePlan& plan, const RingLayout& ring, const RenderOptions& options,
                          bool multisampled) {
    std::optional<Pass> current;
    for (const frame::Stage& stage : plan.stages) {
        const Stopwatch watch;
        StageReport& report = report_.stages[static_cast<std::size_t>(stage.kind)];
        device_->beginStage(stage.kind);
        for (std::uint32_t i = 0; i < stage.batchCount; ++i) {
            const frame::Batch& batch = plan.batches[stage.firstBatch + i];
            if (isSkipped(batch.program, options)) {
                continue;
            }
            if (const Pass pass = passOf(batch.program, options); pass != current) {
                device_->beginPass(pass);
                current = pass;
            }
            drawBatch(batch, ring.commands, options, multisampled);
            ++report.batches;
            report.draws += isOneDraw(batch.program) ? std::min(batch.commandCount, 1u) : batch.commandCount;
        }
        device_->endStage(stage.kind);
        report.cpuMs += watch.milliseconds();
    }
}

Result<void> Renderer::render(const frame::FramePlan& plan, RenderTarget& target,
                              const RenderOptions& options) {
    LIMEN_ASSERT(scene_ != nullptr, "a scene is uploaded before a frame is drawn");
    LIMEN_ASSERT(options.wantIds || options.shading != Shading::IdsOnly, "a frame shows something");
    LIMEN_ASSERT(!options.wantLayers || target.options().layers, "the target is made to count layers");
    const bool multisampled = target.options().samples > 0;
    LIMEN_ASSERT(!multisampled || (!options.wantIds && !options.wantLayers),
                 "ids and layers have one sample a pixel");
    assertSound(plan);
    if (Result<void> prepared = preparePrograms(plan, options, multisampled); !prepared) {
        return prepared;
    }
    const Stopwatch watch;
    report_ = {};
    for (std::size_t i = 0; i < report_.stages.size(); ++i) {
        report_.stages[i].kind = static_cast<frame::StageKind>(i);
    }
    const RingLayout ring = layOutRing(plan);
    if (Result<void> reserved = device_->reserveRing(ring.total); !reserved) {
        return reserved;
    }
    device_->setGeometry(scene_->vertices, scene_->indices); // another renderer may have drawn since
    const std::span<std::byte> memory = device_->beginFrame(target.handle());
    layout::FrameConstants constants = plan.constants;
    target.place(constants);
    const auto arrays = frameArrays(plan, constants);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        copyTo(memory, ring.offsets[i], arrays[i]);
    }
    copyTo(memory, ring.commands, bytesOf(plan.commands));
    bindAll(ring);
    clearTarget(plan, options);
    drawStages(plan, ring, options, multisampled);
    if (multisampled) {
        device_->resolve();
    }
    device_->endFrame();
    report_.cpuMs = watch.milliseconds();
    return {};
}

FrameReport Renderer::report() const {
    FrameReport report = report_;
    report.glCalls = device_->glCalls();
    report.ringStalls = device_->ringStalls();
    const StageTimes times = device_->stageTimes();
    for (std::size_t i = 0; i < times.size(); ++i) {
        report.stages[i].gpuMs = times[i];
    }
    return report;
}

DriverReport Renderer::driver() const {
    const Capabilities& capabilities = device_->capabilities();
    DriverReport report{capabilities.vendor, capabilities.renderer, capabilities.version, "", 0, 0};
    if (scene_ != nullptr) {
        report.textureMode = scene_->textures.bindless() ? "bindless" : "array pages";
        report.pages = static_cast<std::uint32_t>(scene_->textures.pages().size());
        report.resampledTextures = scene_->textures.resampled();
    }
    return report;
}

} // namespace limen::gpu
