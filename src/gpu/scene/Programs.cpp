#include "gpu/scene/Programs.h"

#include "core/Assert.h"

#include <utility>

namespace limen::gpu {
namespace {

bool hasGatedVariant(Drawing drawing, frame::Program program) {
    switch (program) {
    case frame::Program::Opaque:
    case frame::Program::CutOut:
    case frame::Program::Terrain:
    case frame::Program::Blended:
        return true;
    case frame::Program::SkyPlain:
    case frame::Program::SkyObjects:
        return drawing == Drawing::Fast; // the exact ones always test
    case frame::Program::Ownership:
    case frame::Program::Stamp:
    case frame::Program::Fence:
    case frame::Program::Clearing:
        return false;
    }
    return false;
}

bool hasLampVariant(Drawing drawing, frame::Program program) {
    return drawing == Drawing::Fast &&
           (program == frame::Program::Opaque || program == frame::Program::CutOut ||
            program == frame::Program::Blended);
}

bool hasDetailVariant(frame::Program program, ProgramVariant variant) {
    return !variant.flat && (program == frame::Program::Opaque || program == frame::Program::Terrain);
}

bool hasPixelLampVariant(Drawing drawing, frame::Program program, ProgramVariant variant) {
    const bool isMesh = program == frame::Program::Opaque || program == frame::Program::CutOut ||
                        program == frame::Program::Blended;
    return isMesh && !variant.flat && (drawing == Drawing::Exact || variant.lamps);
}

/// The programs of lit frames, which are built before they are used. Others are built when a frame needs them.
constexpr std::size_t kBuiltPrograms = static_cast<std::size_t>(frame::Program::Blended) + 1;
/// The variants of each. Where a program lacks one, it is the same as an earlier one.
constexpr std::array<ProgramVariant, 5> kBuiltVariants{{{.gated = false},
                                                        {.gated = true},
                                                        {.gated = true, .memberLists = true},
                                                        {.gated = false, .shells = false},
                                                        {.gated = true, .shells = false}}};

struct Shaders {
    const char* name;
    const char* vertex;
    const char* fragment;
};

Shaders shadersOf(Drawing drawing, frame::Program program) {
    const bool fast = drawing == Drawing::Fast;
    const char* const mesh = fast ? "fast.vert" : "mesh.vert";
    switch (program) {
    case frame::Program::Ownership:
        return {"ownership", "ownership.vert", "ownership.frag"};
    case frame::Program::Opaque:
        return {"opaque", mesh, fast ? "fastmesh.frag" : "opaque.frag"};
    case frame::Program::CutOut:
        return {"cutout", mesh, fast ? "fastmesh.frag" : "cutout.frag"};
    case frame::Program::Terrain:
        return {"terrain", mesh, fast ? "fastterrain.frag" : "terrain.frag"};
    case frame::Program::SkyPlain:
        return {"sky plain", "skyplain.vert", "skyplain.frag"};
    case frame::Program::SkyObjects:
        return {"sky objects", fast ? "fastsky.vert" : "skyobjects.vert",
                fast ? "fastsky.frag" : "skyobjects.frag"};
    case frame::Program::Blended:
        return {"blended", mesh, fast ? "fastblended.frag" : "blended.frag"};
    case frame::Program::Stamp:
        return {"stamp", "ownership.vert", "opening.frag"};
    case frame::Program::Fence:
        return {"fence", "ownership.vert", "opening.frag"};
    case frame::Program::Clearing:
        return {"clearing", "skyplain.vert", "clearing.frag"};
    }
    return {"", "", ""};
}

bool hasListVariant(Drawing drawing, frame::Program program, ProgramVariant variant) {
    return drawing == Drawing::Fast && variant.gated && hasGatedVariant(drawing, program) &&
           program != frame::Program::SkyPlain && program != frame::Program::SkyObjects;
}

/// Exact programs do more for shells (onpolygon.glsl). The ground is none in any variant.
bool hasShellVariant(Drawing drawing, frame::Program program) {
    return drawing == Drawing::Exact &&
           (program == frame::Program::Opaque || program == frame::Program::CutOut);
}

bool hasClippedVariant(frame::Program program) {
    return !drawsOpenings(program);
}

bool hasFlatVariant(frame::Program program) {
    return !drawsOpenings(program) && program != frame::Program::SkyObjects;
}

} // namespace

bool drawsVoids(Drawing drawing, frame::Program program, ProgramVariant variant) {
    return drawing == Drawing::Fast && program == frame::Program::SkyPlain && variant.gated &&
           !variant.clipped;
}

ProgramSource programSource(Drawing drawing, frame::Program program, ProgramVariant variant,
                            const TextureBinding& textures) {
    const bool fast = drawing == Drawing::Fast;
    const Shaders shaders = shadersOf(drawing, program);
    ProgramSource source{shaders.name, shaders.vertex, shaders.fragment, {}, textures};
    const auto vary = [&source](const char* name, const char* define) {
        source.label += std::string(" ") + name;
        source.defines.emplace_back(define);
    };
    if (drawsVoids(drawing, program, variant)) {
        source.label = "voids";
        source.fragmentShader = "voids.frag";
        source.defines.emplace_back("VOIDS");
    }
    if (program == frame::Program::Blended && variant.flat) {
        source.label = "layers";
        source.fragmentShader = fast ? "fastlayers.frag" : "layers.frag";
    } else if (hasFlatVariant(program) && variant.flat) {
        vary("flat", "FLAT");
    }
    if (hasGatedVariant(drawing, program) && variant.gated)
        vary("gated", "GATED");
    if (hasLampVariant(drawing, program) && variant.lamps)
        vary("lamps", "LAMPS");
    if (hasDetailVariant(program, variant) && variant.details)
        vary("details", "DETAILS");
    if (hasPixelLampVariant(drawing, program, variant) && variant.pixelLamps)
        vary("pixel lamps", "PIXEL_LAMPS");
    if (hasClippedVariant(program) && variant.clipped)
        vary("clipped", "CLIPPED");
    if (hasListVariant(drawing, program, variant) && variant.memberLists)
        vary("member lists", "MEMBER_LISTS");
    if (hasShellVariant(drawing, program) && !variant.shells)
        vary("without shells", "NO_SHELLS");
    if (!fast && program == frame::Program::Terrain)
        source.defines.emplace_back("NO_SHELLS");
    if (program == frame::Program::Clearing)
        source.defines.emplace_back("CLEARING");
    if (program == frame::Program::Stamp)
        source.defines.emplace_back("AT_FAR");
    if (variant.multisampled)
        vary("multisampled", "MULTISAMPLED");
    if (fast && (variant.ids || variant.flat) && hasFlatVariant(program))
        vary("ids", "IDS");
    if (fast)
        source.defines.emplace_back("FAST");
    if (program == frame::Program::Terrain)
        source.defines.emplace_back("TERRAIN");
    if (fast && program == frame::Program::CutOut)
        source.defines.emplace_back("CUTOUT");
    if (fast && program == frame::Program::Blended)
        source.defines.emplace_back("BLENDED");
    return source;
}

Programs::Programs(Device& device, Drawing drawing, SceneBindings textures,
                   std::span<const std::string> defines)
    : device_(&device), drawing_(drawing), textures_(std::move(textures)),
      defines_(defines.begin(), defines.end()) {
    for (auto& variants : handles_)
        variants.fill(ProgramHandle::Invalid);
}

Result<Programs> Programs::create(Device& device, Drawing drawing, const SceneBindings& textures,
                                  std::span<const std::string> defines) {
    Programs programs(device, drawing, textures, defines);
    for (bool isBuilt = false; !isBuilt;) {
        std::size_t bytes = 1;
        const Result<bool> next = programs.buildNext(bytes);
        if (!next)
            return Failure(next.error());
        isBuilt = *next;
    }
    return programs;
}

Result<bool> Programs::buildNext(std::size_t& bytes) {
    for (; built_ < kBuiltVariants.size() * kBuiltPrograms; ++built_) {
        const auto program = static_cast<frame::Program>(built_ / kBuiltVariants.size());
        if (program == frame::Program::Clearing && drawing_ == Drawing::Exact)
            continue;
        ProgramVariant variant = kBuiltVariants[built_ % kBuiltVariants.size()];
        variant.details =
            program == frame::Program::Terrain ? textures_.grainedLand : textures_.grainedMeshes;
        variant.ids = drawing_ == Drawing::Exact;
        if (has(program, variant))
            continue;
        if (bytes == 0)
            return false;
        bytes = 0;
        if (Result<void> made = prepare(program, variant); !made)
            return Failure(made.error());
    }
    return true;
}

bool Programs::has(frame::Program program, ProgramVariant variant) const {
    return handles_[static_cast<std::size_t>(program)][indexOf(program, variant)] != ProgramHandle::Invalid;
}

std::size_t Programs::indexOf(frame::Program program, ProgramVariant variant) const {
    const std::size_t gated = variant.gated && hasGatedVariant(drawing_, program) ? 1 : 0;
    const std::size_t flat = variant.flat && hasFlatVariant(program) ? 2 : 0;
    const std::size_t lamps = hasLampVariant(drawing_, program) && variant.lamps ? 16 : 0;
    const std::size_t ids = drawing_ == Drawing::Fast && variant.ids ? 8 : 0;
    const std::size_t details = hasDetailVariant(program, variant) && variant.details ? 32 : 0;
    const std::size_t pixel = hasPixelLampVariant(drawing_, program, variant) && variant.pixelLamps ? 64 : 0;
    const std::size_t clipped = hasClippedVariant(program) && variant.clipped ? 128 : 0;
    const std::size_t shells = hasShellVariant(drawing_, program) && !variant.shells ? 256 : 0;
    const std::size_t lists = hasListVariant(drawing_, program, variant) && variant.memberLists ? 512 : 0;
    return lists + shells + gated + flat + (variant.multisampled ? 4 : 0) + ids + lamps + details + pixel +
           clipped;
}

Result<void> Programs::prepare(frame::Program program, ProgramVariant variant) {
    ProgramHandle& handle = handles_[static_cast<std::size_t>(program)][indexOf(program, variant)];
    if (handle != ProgramHandle::Invalid)
        return {};
    const TextureBinding& sampled = program == frame::Program::Terrain ? textures_.terrain : textures_.meshes;
    ProgramSource source = programSource(drawing_, program, variant, sampled);
    source.defines.insert(source.defines.end(), textures_.defines.begin(), textures_.defines.end());
    source.defines.insert(source.defines.end(), defines_.begin(), defines_.end());
    Result<ProgramHandle> made = device_->createProgram(source);
    if (!made)
        return Failure(made.error());
    handle = *made;
    return {};
}

Programs::Programs(Programs&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)), drawing_(other.drawing_),
      textures_(std::move(other.textures_)), defines_(std::move(other.defines_)), handles_(other.handles_),
      built_(other.built_) {}

Programs& Programs::operator=(Programs&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(drawing_, other.drawing_);
    std::swap(textures_, other.textures_);
    std::swap(defines_, other.defines_);
    std::swap(handles_, other.handles_);
    std::swap(built_, other.built_);
    return *this;
}

Programs::~Programs() {
    if (device_ == nullptr)
        return;
    for (const auto& variants : handles_) {
        for (ProgramHandle handle : variants)
            if (handle != ProgramHandle::Invalid)
                device_->destroyProgram(handle);
    }
}

ProgramHandle Programs::get(frame::Program program, ProgramVariant variant) const {
    const ProgramHandle handle = handles_[static_cast<std::size_t>(program)][indexOf(program, variant)];
    LIMEN_ASSERT(handle != ProgramHandle::Invalid, "the program is built");
    return handle;
}

} // namespace limen::gpu
