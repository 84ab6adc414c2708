#pragma once

#include "gpu/RendererOptions.h"
#include "gpu/device/Device.h"

#include <array>

namespace limen::gpu {

/// Build variant of a batch's program.
struct ProgramVariant {
    bool gated = false;        ///< with the ownership test; without effect on ownership and sky programs
    bool flat = false;         ///< coloured by id (RenderOptions::shading); for Blended: counts layers
    bool multisampled = false; ///< for multisampled targets
    bool lamps = false;        ///< with lamps; without effect on Drawing::Exact, whose programs all have them
    bool details = false;      ///< with detail pictures; only for opaque meshes and ground
    bool pixelLamps = false;   ///< lamps light walls in fragments; of Drawing::Fast only with `lamps`
    bool ids = true;           ///< with ids; without effect on Drawing::Exact, whose programs all have them
    bool clipped = false;      ///< with clip distances and without the ownership test
    bool memberLists =
        false;          ///< of gated programs of Drawing::Fast: for more visits than frame::VisitBits has
    bool shells = true; ///< draws may be shells of cells; without effect on Drawing::Fast
};

/// Whether a program draws voids: the gated plain sky of the fast way does, and nothing else (voids.frag).
[[nodiscard]] bool drawsVoids(Drawing drawing, frame::Program program, ProgramVariant variant);

/// Sources and macros of a batch's program.
[[nodiscard]] ProgramSource programSource(Drawing drawing, frame::Program program, ProgramVariant variant,
                                          const TextureBinding& textures);

/// Texture bindings and macros of a scene's programs.
struct SceneBindings {
    TextureBinding meshes, terrain;
    bool grainedMeshes = false, grainedLand = false; ///< the scene has detail pictures for them
    std::vector<std::string> defines{};              ///< frame::SceneUpload::defines
    friend bool operator==(const SceneBindings&, const SceneBindings&) = default;
};

/// All programs of a frame for the bindings of a scene. Destroyed with this.
class Programs {
public:
    /// Builds the programs of lit frames. `defines` go to every shader, too, including later ones. Errors: Driver,
    /// with the log of the first that fails.
    [[nodiscard]] static Result<Programs> create(Device& device, Drawing drawing,
                                                 const SceneBindings& textures,
                                                 std::span<const std::string> defines = {});
    /// With no program built.
    Programs(Device& device, Drawing drawing, SceneBindings textures, std::span<const std::string> defines);
    Programs(Programs&& other) noexcept;
    Programs& operator=(Programs&& other) noexcept;
    ~Programs();

    /// Builds the next program of lit frames and sets `bytes` to 0. True when all are built. Between frames.
    /// Errors: Driver, with the log.
    [[nodiscard]] Result<bool> buildNext(std::size_t& bytes);
    [[nodiscard]] const SceneBindings& bindings() const { return textures_; }
    /// Builds a program unless it exists. Between frames. Errors: Driver, with the log.
    [[nodiscard]] Result<void> prepare(frame::Program program, ProgramVariant variant);
    /// Requires that `prepare` built it.
    [[nodiscard]] ProgramHandle get(frame::Program program, ProgramVariant variant) const;

private:
    static constexpr std::size_t kPrograms = frame::kProgramCount;
    static constexpr std::size_t kVariants = 1024;
    [[nodiscard]] bool has(frame::Program program, ProgramVariant variant) const;
    [[nodiscard]] std::size_t indexOf(frame::Program program, ProgramVariant variant) const;

    Device* device_ = nullptr;
    Drawing drawing_ = Drawing::Exact;
    SceneBindings textures_;
    std::vector<std::string> defines_;
    std::array<std::array<ProgramHandle, kVariants>, kPrograms> handles_{};
    std::size_t built_ = 0; ///< number of programs of lit frames built, by program and variant
};

} // namespace limen::gpu
