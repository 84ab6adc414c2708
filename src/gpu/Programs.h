#pragma once

#include "gpu/Device.h"

#include <array>

namespace limen::gpu {

/// What the program of a batch is built from. Ownership and sky have one variant: `gated` changes nothing
/// there.
[[nodiscard]] ProgramSource programSource(frame::Program program, bool gated, const TextureBinding& textures);

/// Which images a program writes.
[[nodiscard]] Pass passOf(frame::Program program, bool wantIds);

/// What textures the programs of a scene sample.
struct SceneBindings {
    TextureBinding meshes, terrain;
};

/// All programs of a frame, for one way of binding textures. Destroyed with this.
class Programs {
public:
    /// `defines` go to every shader. Errors: Driver, with the log of the first that does not build.
    [[nodiscard]] static Result<Programs> create(Device& device, const SceneBindings& textures,
                                                 std::span<const std::string> defines = {});
    Programs(Programs&& other) noexcept;
    Programs& operator=(Programs&& other) noexcept;
    ~Programs();

    [[nodiscard]] ProgramHandle get(frame::Program program, bool gated) const;

private:
    static constexpr std::size_t kPrograms = static_cast<std::size_t>(frame::Program::Blended) + 1;
    explicit Programs(Device& device);

    Device* device_ = nullptr;
    std::array<std::array<ProgramHandle, 2>, kPrograms> handles_{}; // [program][gated]
};

} // namespace limen::gpu
