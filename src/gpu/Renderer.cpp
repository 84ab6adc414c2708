#include "gpu/Renderer.h"

#include "core/Assert.h"
#include "frame/IdColour.h"
#include "gpu/BatchDraws.h"
#include "gpu/DrawCulling.h"
#include "gpu/FastDraws.h"
#include "gpu/FrameRing.h"
#include "gpu/PassSelection.h"
#include "gpu/scene/ResidentScene.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

// Attempts at an upload when the driver is out of memory.
constexpr int kUploadAttempts = 3;

// FrameView::coverageDecides of a plan that this way of drawing can draw.
bool coverageDecides(Drawing drawing, const frame::FramePlan& plan) {
    return drawing == Drawing::Fast && plan.gate == frame::Gate::Ownership;
}

// Asserts the conditions without which the GPU would read out of bounds or loop.
void assertSound(const frame::FramePlan& plan, std::uint32_t staticPieces, Drawing drawing) {
    LIMEN_ASSERT(plan.constants.visitCount > 0 && plan.visits.size() >= plan.constants.visitCount,
                 "a plan has at least the root visit");
    const bool byCoverage = coverageDecides(drawing, plan);
    for (const layout::OwnershipVertex& vertex : plan.ownershipVertices) {
        LIMEN_ASSERT(vertex.visit < std::min(plan.visits.size(), std::size_t{layout::kOwnedOutside}),
                     "an opening's visit is in the plan");
        LIMEN_ASSERT(!byCoverage || vertex.outlineCount <= layout::kCoverWindow,
                     "no outline is drawn around the window: FrameView::coverageDecides");
        LIMEN_ASSERT(byCoverage || (vertex.outlineCount & layout::kOnScreen) == 0,
                     "only fast frames have regions on the screen");
    }
    LIMEN_ASSERT(!plan.blocks.empty(), "at least the eye's block is resident");
    LIMEN_ASSERT(plan.constants.staticPieces == staticPieces, "the plan was made for this scene");
    for (std::size_t i = 0; i < plan.visits.size(); ++i) {
        const std::uint32_t parent = plan.visits[i].parent;
        LIMEN_ASSERT(parent == layout::kNoVisit || parent < i, "parents precede children");
    }
    for (const frame::Batch& batch : plan.batches) {
        const std::size_t size =
            drawsOpenings(batch.program) ? plan.ownershipVertices.size() : plan.runs.size();
        const bool isOfRects =
            batch.program == frame::Program::SkyPlain || batch.program == frame::Program::Clearing;
        LIMEN_ASSERT(isOfRects || std::uint64_t{batch.first} + batch.count <= size,
                     "a batch is within the runs");
        LIMEN_ASSERT(
            batch.program != frame::Program::Clearing ||
                (drawing == Drawing::Fast && std::uint64_t{batch.first} + batch.count <= plan.rects.size()),
            "FrameView::rootFirst is for the fast way, and its rectangles are in the plan");
        LIMEN_ASSERT(batch.program != frame::Program::SkyPlain || batch.count > 0 ||
                         batch.first + batch.draws <= plan.clipSets.size(),
                     "each triangle of the sky has a clip set");
        LIMEN_ASSERT(batch.program != frame::Program::SkyPlain ||
                         std::uint64_t{batch.first} + batch.count <=
                             std::max(plan.rects.size(), plan.clipSets.size()),
                     "each rectangle of the sky is in the plan");
    }
    for (const frame::PieceRun& run : plan.runs) {
        LIMEN_ASSERT(std::uint64_t{run.firstPiece} + run.pieceCount <= staticPieces + plan.pieces.size(),
                     "a run is within the pieces");
    }
    for (const frame::Stage& stage : plan.stages) {
        LIMEN_ASSERT(std::uint64_t{stage.firstBatch} + stage.batchCount <= plan.batches.size(),
                     "a stage is within the batches");
    }
}

bool hasRepeatedStages(const frame::FramePlan& plan) {
    std::array<bool, frame::kStageCount> seen{};
    return std::any_of(plan.stages.begin(), plan.stages.end(), [&](const frame::Stage& stage) {
        return std::exchange(seen[static_cast<std::size_t>(stage.kind)], true);
    });
}

bool hasClearing(const frame::FramePlan& plan) {
    return std::any_of(plan.batches.begin(), plan.batches.end(),
                       [](const frame::Batch& batch) { return batch.program == frame::Program::Clearing; });
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

bool isFlat(const RenderOptions& options) {
    return options.shading != Shading::Lit;
}

/// Only colour-only frames split surfaces: the nearly opaque part writes depth, for a surface that has none
/// otherwise.
bool splitsSurfaces(const RenderOptions& options) {
    return options.shading == Shading::Lit && !options.wantIds && !options.wantLayers;
}

/// Whether objects of the sky may stand for the plain sky: it has an id of its own.
bool showsCover(const frame::FramePlan& plan, const RenderOptions& options) {
    return options.shading == Shading::Lit && !options.wantIds && !options.wantLayers && !plan.clips;
}

glm::vec4 clearColour(const frame::FramePlan& plan, const RenderOptions& options) {
    if (!isFlat(options))
        return plan.constants.voidColour;
    const auto [r, g, b] = frame::colourOfId(layout::kVoidId);
    return glm::vec4(r, g, b, 255) / 255.0f;
}

std::vector<std::string> definesOf(const RendererOptions& options) {
    std::vector<std::string> defines = options.shaderDefines;
    if (options.drawing == Drawing::Exact && options.exactOutlines)
        defines.emplace_back("EXACT_OUTLINES");
    return defines;
}

} // namespace

Renderer::Renderer(Device& device, RendererOptions options)
    : device_(&device), options_(std::move(options)), fast_(std::make_unique<FastDraws>()),
      spare_(std::make_unique<SpareBuffers>(device)) {
    options_.textures.nearestLevel = isFast();
}

Renderer::~Renderer() = default;

Result<void> Renderer::upload(const frame::SceneUpload& upload) {
    Result<void> done = uploadOnce(upload);
    for (int tried = 1; tried < kUploadAttempts && !done && done.error().code == ErrorCode::Driver; ++tried) {
        device_->finishFrames(); // drivers free destroyed objects only then
        done = uploadOnce(upload);
    }
    return done;
}

Result<void> Renderer::uploadOnce(frame::SceneUpload upload) {
    Result<StagedScene> staged = stageScene(std::move(upload), options_, device_->capabilities(), state());
    if (!staged)
        return Failure(staged.error());
    if (Result<void> begun = begin(std::move(*staged)); !begun)
        return begun;
    for (bool isThere = false; !isThere;) {
        const Result<bool> advanced = advance(std::numeric_limits<std::size_t>::max());
        if (!advanced) {
            retired_.clear(); // the incomplete scene is destroyed at once
            spare_->clear();
            return Failure(advanced.error());
        }
        isThere = *advanced;
    }
    scene_ = std::move(coming_);
    spare_->endScene();
    return {};
}

SceneState Renderer::state() const {
    if (scene_ == nullptr)
        return {};
    return {scene_->textures().contents(), scene_->programs().bindings()};
}

Result<void> Renderer::makeRoom() {
    for (const SizedBuffer& buffer : scene_ != nullptr ? scene_->buffers() : std::span<const SizedBuffer>())
        if (Result<void> added = spare_->addTwin(buffer); !added)
            return added;
    return {};
}

std::shared_ptr<Programs> Renderer::programsFor(const SceneBindings& bindings) {
    constexpr std::size_t kMost = 3;
    auto found = std::find_if(programs_.begin(), programs_.end(),
                              [&](const auto& programs) { return programs->bindings() == bindings; });
    if (found == programs_.end()) {
        programs_.resize(std::min(programs_.size(), kMost - 1));
        found = programs_.insert(programs_.end(), std::make_shared<Programs>(*device_, options_.drawing,
                                                                             bindings, definesOf(options_)));
    }
    std::rotate(programs_.begin(), found, found + 1);
    return programs_.front();
}

Result<void> Renderer::createCulling() {
    if (isFast())
        return {};
    if (culling_ == nullptr) {
        Result<DrawCulling> culling = DrawCulling::create(
            *device_, definesOf(options_), options_.exactOutlines ? options_.culling : Culling::None);
        if (!culling)
            return Failure(culling.error());
        culling_ = std::make_unique<DrawCulling>(std::move(*culling));
    }
    culling_->tryAgain();
    return {};
}

Result<void> Renderer::begin(StagedScene staged) {
    drop();
    if (Result<void> created = createCulling(); !created)
        return created;
    std::shared_ptr<Programs> programs = programsFor(staged.bindings);
    coming_ = std::make_unique<ResidentScene>(*device_, std::move(staged), std::move(programs), scene_.get(),
                                              *spare_);
    return {};
}

Result<bool> Renderer::advance(std::size_t bytes) {
    releaseSome();
    if (coming_ == nullptr)
        return true;
    Result<bool> advanced = coming_->advance(bytes);
    if (!advanced)
        drop();
    return advanced;
}

void Renderer::swap() {
    LIMEN_ASSERT(coming_ != nullptr, "a sliced upload is complete");
    if (scene_ != nullptr)
        retired_.push_back({std::move(scene_), frames_});
    scene_ = std::move(coming_);
    spare_->endScene();
}

void Renderer::drop() {
    if (coming_ != nullptr) { // no frame has read it: it can be released at once, in slices
        coming_->markUnused();
        retired_.insert(retired_.begin(), {std::move(coming_), 0});
    }
}

void Renderer::releaseSome() {
    if (spare_->releaseSome())
        return;
    if (retired_.empty() ||
        (retired_.front().frame != 0 && frames_ - retired_.front().frame < kFramesInFlight))
        return;
    retired_.front().scene->markUnused();
    if (!retired_.front().scene->releaseSome())
        retired_.erase(retired_.begin());
}

FrameKind Renderer::kindOf(const frame::FramePlan& plan, const RenderTarget& target,
                           const RenderOptions& options) const {
    const layout::vec4& tiling = plan.constants.detailTiling;
    return {.drawing = options_.drawing,
            .exactOutlines = options_.exactOutlines,
            .multisampled = target.options().samples > 0,
            .several = plan.constants.visitCount > 1,
            .grainedMeshes = tiling[layout::kDetailOfExteriors] > 0 || tiling[layout::kDetailOfShells] > 0,
            .grainedLand = tiling[layout::kDetailOfLand] > 0,
            .pixelLamps = (plan.constants.flags & layout::kFramePixelLamps) != 0,
            .clipped = plan.clips,
            .facesOpenings = coverageDecides(options_.drawing, plan),
            .overlaps = choices().overlaps && plan.gate == frame::Gate::Ownership && !options.wantIds &&
                        !options.wantLayers,
            .plainSky = isFast() && showsCover(plan, options) ? plan.plainSky : frame::RectRun(),
            .manyVisits = FastDraws::listsMembers(plan),
            .options = options};
}

Result<void> Renderer::preparePrograms(const frame::FramePlan& plan, const FrameKind& frame) {
    Result<void> prepared;
    for (const frame::Batch& batch : plan.batches) {
        if (!isDrawn(batch.program, frame.options))
            continue;
        for (const bool lamps : {false, true}) // whichever the draws need later
            for (const BatchDraw& draw : drawsOf(batch, {0, 0, 0, lamps, lamps}, frame))
                if (prepared)
                    prepared = scene_->programs().prepare(batch.program, draw.variant);
    }
    return prepared;
}

BufferHandle Renderer::indicesFor(const RenderOptions& options) const {
    if (!isFast())
        return culling_->drawsStaticIndices() ? scene_->indices() : culling_->keptIndices();
    // The polygon of an id is a value of each triangle's own vertices.
    return options.wantIds || options.wantLayers ? scene_->indices() : scene_->sharedIndices();
}

std::uint32_t Renderer::prepareDraws(const frame::FramePlan& plan, const RenderOptions& options,
                                     const RenderTarget& target) {
    if (isFast()) {
        fast_->prepare(plan, options, scene_->tables());
        return fast_->drawCount();
    }
    culling_->prepare(plan, options, target);
    return culling_->slotCount();
}

const BatchSlots& Renderer::slotsOf(std::size_t batch) const {
    return isFast() ? fast_->slotsOf(batch) : culling_->slotsOf(batch);
}

Viewport Renderer::viewportOf(const RenderTarget& target) const {
    const Viewport picture = target.viewport();
    return isFast() && target.options().wide ? picture.doubled(device_->capabilities().maxViewport) : picture;
}

void Renderer::writeRing(const frame::FramePlan& plan, const FrameRing& ring, const RenderOptions& options,
                         const RenderTarget& target, std::span<std::byte> memory) {
    layout::DeviceConstants constants;
    target.place(plan.constants, constants);
    const Viewport drawn = viewportOf(target), picture = target.viewport();
    constants.flags |= (drawn.width > picture.width ? layout::kFrameWide : 0) |
                       (drawn.height > picture.height ? layout::kFrameHigh : 0);
    ring.locate(constants);
    if (!isFast())
        culling_->describe(constants);
    constants.flags |= splitsSurfaces(options) ? layout::kFrameSplits : 0;
    ring.write(constants, memory);
    if (isFast())
        fast_->write(plan, scene_->tables(), ring, memory, device_->baseInstanceAt(ring.records()));
    else
        culling_->writeRuns(plan, options, ring.slotGroups(memory), ring.runs(memory));
}

void Renderer::bindAll(const FrameRing& ring, bool withDrawn) {
    StorageBindings storage = scene_->storage();
    ring.bind(storage);
    if (isFast())
        storage[layout::kBindKeptIndices] = storage[layout::kBindTiles] = storage[layout::kBindIndices];
    else
        culling_->bind(storage);
    device_->bindStorage(storage);
    device_->bindTextures(scene_->boundTextures(), withDrawn);
}

void Renderer::clearTarget(const frame::FramePlan& plan, const FrameKind& frame) {
    const RenderOptions& options = frame.options;
    device_->clear(TargetImage::Ownership, rootOwner(plan.constants.rootZone));
    if (frame.overlaps)
        return;
    // With a clearing every pixel gets a surface, a void or the sky.
    const bool isCovered = hasClearing(plan);
    if (options.shading != Shading::IdsOnly && !isCovered)
        device_->clear(TargetImage::Colour, clearColour(plan, options));
    if (options.wantLayers)
        device_->clear(TargetImage::Layers, glm::vec4(0.0f));
    if (options.wantIds && !isCovered)
        device_->clear(TargetImage::Id, std::uint32_t{layout::kVoidId});
    device_->clear(TargetImage::Depth, 0.0f);
}

void Renderer::drawPlainSky(const frame::Batch& batch, bool voids, const FrameKind& frame) {
    if (voids && !frame.multisampled)
        device_->readDrawn();
    if (voids && batch.count > 0)
        device_->drawVertices(layout::kSkyRectVertices + 6 * batch.first, 6 * batch.count);
    else if (!voids && frame.plainSky.count > 0)
        device_->drawVertices(layout::kSkyRectVertices + 6 * frame.plainSky.first, 6 * frame.plainSky.count);
    else if (frame.clipped)
        device_->drawVertices(3 * batch.first, 3 * batch.draws);
    else
        device_->drawVertices(0, 3);
}

void Renderer::drawBatch(const frame::Batch& batch, const BatchSlots& slots, std::size_t commands,
                         const FrameKind& frame) {
    for (const BatchDraw& draw : drawsOf(batch, slots, frame)) {
        DrawState state = stateOf(batch.program, draw.variant, frame);
        state.program = scene_->programs().get(batch.program, draw.variant);
        device_->setState(state);
        switch (batch.program) {
        case frame::Program::Ownership:
        case frame::Program::Stamp:
        case frame::Program::Fence:
            device_->drawVertices(batch.first, batch.count);
            break;
        case frame::Program::Clearing:
            device_->readDrawn();
            device_->drawVertices(layout::kSkyRectVertices + 6 * batch.first, 6 * batch.count);
            break;
        case frame::Program::SkyPlain:
            drawPlainSky(batch, drawsVoids(frame.drawing, batch.program, draw.variant), frame);
            break;
        default:
            device_->drawIndirect(commands + draw.firstSlot * sizeof(layout::DrawCommand), draw.count);
        }
    }
}

void Renderer::drawStages(const frame::FramePlan& plan, std::size_t commands, const FrameKind& frame) {
    std::optional<Pass> current;
    bool isCleared = !frame.overlaps;
    timesStages_ = !hasRepeatedStages(plan); // a timer measures one interval a frame
    for (const frame::Stage& stage : plan.stages) {
        const Stopwatch watch;
        StageReport& report = report_.stages[static_cast<std::size_t>(stage.kind)];
        if (stage.clearsDepth)
            device_->clear(TargetImage::Depth, 0.0f);
        if (timesStages_)
            device_->beginStage(stage.kind);
        for (std::uint32_t i = 0; i < stage.batchCount; ++i) {
            const frame::Batch& batch = plan.batches[stage.firstBatch + i];
            if (!isFast() && stage.firstBatch + i == plan.firstOccludee && culling_->usesOcclusion())
                culling_->cullOccluded();
            const BatchSlots& slots = slotsOf(stage.firstBatch + i);
            if (!isDrawn(batch.program, frame.options))
                continue;
            report.draws += batch.draws;
            if (slots.isJoined)
                continue;
            if (const Pass pass = passOf(batch.program, frame.options); pass != current) {
                device_->beginPass(pass);
                current = pass;
            }
            if (!isCleared && current == Pass::SolidNoIds) {
                device_->clearPicture(clearColour(plan, frame.options));
                isCleared = true;
            }
            if (frame.overlaps && batch.program == frame::Program::CutOut && batch.turn != frame::Turn::After)
                device_->flush(); // most vertices come now
            drawBatch(batch, slots, commands, frame);
            ++report.batches;
        }
        if (timesStages_)
            device_->endStage(stage.kind);
        report.cpuMs += watch.milliseconds();
    }
    LIMEN_ASSERT(isCleared, "every frame has a solid pass");
}

Result<void> Renderer::render(const frame::FramePlan& plan, RenderTarget& target,
                              const RenderOptions& options) {
    LIMEN_ASSERT(scene_ != nullptr, "a scene is uploaded before a frame is drawn");
    LIMEN_ASSERT(options.wantIds || options.shading != Shading::IdsOnly, "a frame writes colour or ids");
    LIMEN_ASSERT(!options.wantLayers || target.options().layers, "the target has a layers image");
    const FrameKind kind = kindOf(plan, target, options);
    LIMEN_ASSERT(!kind.multisampled || (!options.wantIds && !options.wantLayers),
                 "a multisampled frame has no ids and no layers");
    assertSound(plan, scene_->pieces(), options_.drawing);
    if (Result<void> prepared = preparePrograms(plan, kind); !prepared)
        return prepared;
    const Stopwatch watch;
    report_ = {};
    for (std::size_t i = 0; i < report_.stages.size(); ++i)
        report_.stages[i].kind = static_cast<frame::StageKind>(i);
    const std::uint32_t slots = prepareDraws(plan, options, target);
    const FrameRing ring(plan, slots, device_->capabilities().storageAlignment,
                         isFast() ? RingUse::DrawRecords : RingUse::Instances);
    if (Result<void> reserved = device_->reserveRing(ring.size()); !reserved)
        return reserved;
    // In every frame, because another renderer may have drawn since.
    device_->setGeometry(scene_->vertices(), indicesFor(options));
    device_->setCulling(kind.cullsBackFaces());
    const std::span<std::byte> memory = device_->beginFrame(target.handle(), viewportOf(target));
    writeRing(plan, ring, options, target, memory);
    bindAll(ring, isFast() && !kind.multisampled);
    clearTarget(plan, kind);
    if (!isFast())
        culling_->cull();
    drawStages(plan, ring.commands(), kind);
    if (kind.multisampled)
        device_->resolve();
    Result<void> ended = device_->endFrame();
    report_.cpuMs = watch.milliseconds();
    report_.bytesWritten = ring.size();
    ++frames_;
    return ended;
}

FrameReport Renderer::report() const {
    FrameReport report = report_;
    report.glCalls = device_->glCalls();
    report.ringStalls = device_->ringStalls();
    if (culling_ != nullptr && culling_->failure())
        report.trouble = culling_->failure()->message();
    const StageTimes times = device_->stageTimes();
    for (std::size_t i = 0; timesStages_ && i < times.size(); ++i)
        report.stages[i].gpuMs = times[i];
    return report;
}

DriverChoices Renderer::choices() const {
    return driverChoices(options_, device_->capabilities());
}

DriverReport Renderer::driver() const {
    const Capabilities& capabilities = device_->capabilities();
    DriverReport report{capabilities.vendor, capabilities.renderer, capabilities.version, "", 0, 0};
    if (scene_ != nullptr) {
        report.textureMode = scene_->textures().bindless() ? "bindless" : "array pages";
        report.pages = static_cast<std::uint32_t>(scene_->textures().pages().size());
        report.resampledTextures = scene_->textures().resampled();
    }
    return report;
}

} // namespace limen::gpu
