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
    gpu::TextureHandle page = gpu::TextureHandle::Invalid; ///< the group's texture
    std::uint32_t firstStanding = 0, standingCount = 0;    ///< range in ClassicScene::standing
    std::uint32_t firstMoving = 0, movingCount = 0;        ///< range in ClassicScene::moving
};

/// A static object, ready to be copied into a frame.
struct ClassicObject {
    Sphere bounds;              ///< global
    std::uint32_t instance = 0; ///< index into World::instances
    bool hasLevels = false;     ///< it is not drawn at every distance
    frame::gpu::Instance packed;
};

/// A world on a device, grouped as in renderers before indirect draws: separate textures, and static objects
/// packed once, in one range a group. It uses the shaders of gpu/Renderer.h. The destructor frees all device
/// objects; the device must outlive it.
class ClassicScene {
public:
    /// Requires opaque surfaces only, one texture a mesh, and ground without blending. Dynamic objects are
    /// identified by their index in `dynamics`. Errors: those of textures, buffers and programs.
    [[nodiscard]] static Result<std::unique_ptr<ClassicScene>>
    create(gpu::Device& device, const world::World& world, const world::DynamicState& dynamics);
    ClassicScene(const ClassicScene&) = delete;
    ClassicScene& operator=(const ClassicScene&) = delete;
    ~ClassicScene();

    /// Groups of objects first, then those of the ground.
    [[nodiscard]] std::span<const ClassicGroup> groups() const { return groups_; }
    [[nodiscard]] std::span<const ClassicObject> standing() const { return standing_; }
    /// Indices into DynamicState::instances.
    [[nodiscard]] std::span<const std::uint32_t> moving() const { return moving_; }
    [[nodiscard]] std::uint32_t staticMembers() const { return staticMembers_; }
    [[nodiscard]] gpu::ProgramHandle program(frame::Program program) const {
        return programs_[static_cast<std::size_t>(program)];
    }
    [[nodiscard]] gpu::BufferHandle vertices() const { return vertices_; }
    [[nodiscard]] gpu::BufferHandle indices() const { return indices_; }
    /// All storage bindings of a frame. The frame fills in those of the ring.
    using Storage = std::array<gpu::StorageRange, frame::gpu::kStorageBindings>;
    [[nodiscard]] const Storage& storage() const { return storage_; }
    /// The textures for Device::bindTextures: buffers read as texels, then a slot for a group's texture.
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
    /// Makes a buffer. An error is stored in `missing_`.
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
    std::vector<gpu::TextureStore> pages_; ///< one a texture, by World::textures
    std::array<gpu::ProgramHandle, static_cast<std::size_t>(frame::Program::Blended) + 1> programs_{};
    std::vector<gpu::BufferHandle> owned_;
    std::vector<gpu::TextureHandle> texels_;
    std::optional<Error> missing_; ///< the error of a buffer that could not be made
    gpu::BufferHandle vertices_ = gpu::BufferHandle::Invalid, indices_ = gpu::BufferHandle::Invalid;
    Storage storage_{};
    Textures textures_{};
};

} // namespace limen::bench
