#include "gpu/Programs.h"

#include <utility>

namespace limen::gpu {
namespace {

bool hasGatedVariant(frame::Program program) {
    switch (program) {
    case frame::Program::Opaque:
    case frame::Program::CutOut:
    case frame::Program::Terrain:
    case frame::Program::Blended:
        return true;
    case frame::Program::Ownership:
    case frame::Program::SkyPlain:
    case frame::Program::SkyObjects:
        return false;
    }
    return false;
}

struct Shaders {
    const char* name;
    const char* vertex;
    const char* fragment;
};

Shaders shadersOf(frame::Program program) {
    switch (program) {
    case frame::Program::Ownership:
        return {"ownership", "ownership.vert", "ownership.frag"};
    case frame::Program::Opaque:
        return {"opaque", "mesh.vert", "opaque.frag"};
    case frame::Program::CutOut:
        return {"cutout", "mesh.vert", "cutout.frag"};
    case frame::Program::Terrain:
        return {"terrain", "mesh.vert", "terrain.frag"};
    case frame::Program::SkyPlain:
        return {"sky plain", "skyplain.vert", "skyplain.frag"};
    case frame::Program::SkyObjects:
        return {"sky objects", "skyobjects.vert", "skyobjects.frag"};
    case frame::Program::Blended:
        return {"blended", "mesh.vert", "blended.frag"};
    }
    return {"", "", ""};
}

} // namespace

ProgramSource programSource(frame::Program program, bool gated, const TextureBinding& textures) {
    const Shaders shaders = shadersOf(program);
    ProgramSource source{shaders.name, shaders.vertex, shaders.fragment, {}, textures};
    if (gated && hasGatedVariant(program)) {
        source.label += " gated";
        source.defines.emplace_back("GATED");
    }
    if (program == frame::Program::Terrain) {
        source.defines.emplace_back("TERRAIN");
    }
    return source;
}

Pass passOf(frame::Program program, bool wantIds) {
    switch (program) {
    case frame::Program::Ownership:
        return Pass::Ownership;
    case frame::Program::SkyObjects:
    case frame::Program::Blended:
        return Pass::Blended;
    case frame::Program::Opaque:
    case frame::Program::CutOut:
    case frame::Program::Terrain:
    case frame::Program::SkyPlain:
        return wantIds ? Pass::Solid : Pass::SolidNoIds;
    }
    return Pass::Solid;
}

Programs::Programs(Device& device) : device_(&device) {
    for (auto& variants : handles_) {
        variants.fill(ProgramHandle::Invalid);
    }
}

Result<Programs> Programs::create(Device& device, const SceneBindings& textures,
                                  std::span<const std::string> defines) {
    Programs programs(device);
    for (std::size_t i = 0; i < kPrograms; ++i) {
        const auto program = static_cast<frame::Program>(i);
        const TextureBinding& sampled =
            program == frame::Program::Terrain ? textures.terrain : textures.meshes;
        for (const bool gated : {false, true}) {
            if (gated && !hasGatedVariant(program)) {
                continue;
            }
            ProgramSource source = programSource(program, gated, sampled);
            source.defines.insert(source.defines.end(), defines.begin(), defines.end());
            Result<ProgramHandle> handle = device.createProgram(source);
            if (!handle) {
                return tl::unexpected(handle.error());
            }
            programs.handles_[i][gated ? 1 : 0] = *handle;
        }
    }
    return programs;
}

Programs::Programs(Programs&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)), handles_(other.handles_) {}

Programs& Programs::operator=(Programs&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handles_, other.handles_);
    return *this;
}

Programs::~Programs() {
    if (device_ == nullptr) {
        return;
    }
    for (const auto& variants : handles_) {
        for (ProgramHandle handle : variants) {
            if (handle != ProgramHandle::Invalid) {
                device_->destroyProgram(handle);
            }
        }
    }
}

ProgramHandle Programs::get(frame::Program program, bool gated) const {
    return handles_[static_cast<std::size_t>(program)][gated && hasGatedVariant(program) ? 1 : 0];
}

} // namespace limen::gpu
