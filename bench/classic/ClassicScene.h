#pragma once

#include "frame/GpuLayout.h"
#include "gpu/device/Device.h"
#include "gpu/texture/TextureStore.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace limen::bench {

/// Objects of one mesh and one texture: one draw call of the classic path.
struct ClassicGroup {
    frame::Program program = frame::Program::Opaque;
    std::uint32_t firstIndex = 0, indexCount = 0;          ///< of the opaque range; there is no other
    gpu::TextureHandle page = gpu::TextureHandle::Invalid; ///< its texture
    std::uint32_t firstStanding = 0, standingCount = 0;    ///< a run of ClassicScene::standing
    std::uint32_t firstMoving = 0, movingCount = 0;        ///< a run of ClassicScene::moving
};

/// Something that stands still, ready to be copied into a frame.
struct ClassicObject {
    Sphere bounds; ///< global
    frame::gpu::Instance packed;
};

/// A world on a device, in groups as renderers had them before indirect draws: every texture on its own, what stands still packed
/// once, in one run a group. Shaders are those of gpu/Renderer.h. Gives everything back when it goes; the device must outlive it.
class ClassicScene {
public:
    /// Requires a world whose surfaces are all opaque, each mesh with one texture, ground without blending. Things that move are
    /// told apart by their place in `moment`. Errors: what textures, buffers and programs report.
    [[nodiscard]] static Result<std::unique_ptr<ClassicScene>>
    create(gpu::Device& device, const world::World& world, const world::DynamicState& dynamics);
    ClassicScene(const ClassicScene&) = delete;
    ClassicScene& operator=(const ClassicScene&) = delete;
    ~ClassicScene();

    /// Objects first, then the ground.
    [[nodiscard]] std::span<const ClassicGroup> groups() const { return groups_; }
    [[nodiscard]] std::span<const ClassicObject> standing() const { return standing_; }
    /// Indices into Moment::instances.
    [[nodiscard]] std::span<const std::uint32_t> moving() const { return moving_; }
    [[nodiscard]] std::uint32_t staticMembers() const { return staticMembers_; }
    [[nodiscard]] gpu::ProgramHandle program(frame::Program program) const {
        return programs_[static_cast<std::size_t>(program)];
    }
    [[nodiscard]] gpu::BufferHandle vertices() const { return vertices_; }
    [[nodiscard]] gpu::BufferHandle indices() const { return indices_; }
    /// Every storage binding of a frame; the ring's are up to the frame.
    using Storage = std::array<gpu::StorageRange, frame::gpu::kStorageBindings>;
    [[nodiscard]] const Storage& storage() const { return storage_; }
    /// What Device::bindTextures takes: buffers read as texels, and room for a group's texture behind them.
    using Textures =
        std::array<gpu::TextureHandle, frame::gpu::kUnitFirstPage + 1 - frame::gpu::kUnitVertices>;
    [[nodiscard]] const Textures& textures() const { return textures_; }

private:
    explicit ClassicScene(gpu::Device& device) : device_(device) {}
    [[nodiscard]] Result<void> upload(const world::World& world);
    [[nodiscard]] Result<void> addPages(std::span<const frame::TextureUpload> textures);
    [[nodiscard]] Result<void> addPrograms();
    void addGroups(const world::World& world, const world::DynamicState& dynamics);
    [[nodiscard]] ClassicGroup groupOf(const world::World& world, const world::Instance& instance) const;
    /// What fails is in `missing_`.
    gpu::BufferHandle add(std::string_view label, std::span<const std::byte> bytes);
    void addStorage(std::uint32_t binding, std::string_view label, std::span<const std::byte> bytes);
    [[nodiscard]] Result<void> addTexels(std::uint32_t unit, std::string_view label,
                                         gpu::BufferHandle buffer);

    gpu::Device& device_;
    std::vector<ClassicGroup> groups_;
    std::vector<ClassicObject> standing_;
    std::vector<std::uint32_t> moving_;
    std::vector<frame::gpu::Instance> packed_; ///< by World::instances
    std::uint32_t staticMembers_ = 0;
    std::vector<gpu::TextureStore> pages_; ///< by World::textures, one each
    std::array<gpu::ProgramHandle, static_cast<std::size_t>(frame::Program::Blended) + 1> programs_{};
    std::vector<gpu::BufferHandle> owned_;
    std::vector<gpu::TextureHandle> texels_;
    std::optional<Error> missing_; ///< a buffer that could not be made
    gpu::BufferHandle vertices_ = gpu::BufferHandle::Invalid, indices_ = gpu::BufferHandle::Invalid;
    Storage storage_{};
    Textures textures_{};
};

} // namespace limen::bench
