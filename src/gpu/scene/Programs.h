#pragma once

#include "gpu/device/Device.h"

#include <array>

namespace limen::gpu {

/// The ways in which the program of a batch is built.
struct ProgramVariant {
    bool gated = false; ///< with the ownership test; ownership and sky have it, or do without, either way
    bool flat = false;  ///< coloured by id (RenderOptions::shading); of Blended: the one that counts layers
    bool multisampled = false; ///< for targets with several samples a pixel
};

/// What the program of a batch is built from.
[[nodiscard]] ProgramSource programSource(frame::Program program, ProgramVariant variant,
                                          const TextureBinding& textures);

/// What textures the programs of a scene sample.
struct SceneBindings {
    TextureBinding meshes, terrain;
    friend bool operator==(const SceneBindings&, const SceneBindings&) = default;
};

/// All programs of a frame, for one way of binding textures. Destroyed with this.
class Programs {
public:
    /// Builds those of lit frames. `defines` go to every shader, later ones too. Errors: Driver, with the log of the
    /// first that does not build.
    [[nodiscard]] static Result<Programs> create(Device& device, const SceneBindings& textures,
                                                 std::span<const std::string> defines = {});
    /// None of them built yet.
    Programs(Device& device, SceneBindings textures, std::span<const std::string> defines);
    Programs(Programs&& other) noexcept;
    Programs& operator=(Programs&& other) noexcept;
    ~Programs();

    /// Builds the next of those of lit frames, which uses up all of `bytes`. Yields true when they are all there. Not during a frame.
    /// Errors: Driver, with its log.
    [[nodiscard]] Result<bool> buildNext(std::size_t& bytes);
    [[nodiscard]] const SceneBindings& bindings() const { return textures_; }
    /// Builds one unless it is there. Not during a frame. Errors: Driver, with its log.
    [[nodiscard]] Result<void> prepare(frame::Program program, ProgramVariant variant);
    /// Requires that it was prepared.
    [[nodiscard]] ProgramHandle get(frame::Program program, ProgramVariant variant) const;

private:
    static constexpr std::size_t kPrograms = static_cast<std::size_t>(frame::Program::Blended) + 1;
    static constexpr std::size_t kVariants = 8;
    [[nodiscard]] bool has(frame::Program program, ProgramVariant variant) const;
    [[nodiscard]] static std::size_t indexOf(frame::Program program, ProgramVariant variant);

    Device* device_ = nullptr;
    SceneBindings textures_;
    std::vector<std::string> defines_;
    std::array<std::array<ProgramHandle, kVariants>, kPrograms> handles_{};
    std::size_t built_ = 0; ///< of those of lit frames, two variants a program
};

} // namespace limen::gpu
