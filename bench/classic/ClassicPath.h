#pragma once

#include "ClassicScene.h"
#include "frame/Planner.h"
#include "gpu/RenderTarget.h"

namespace limen::bench {

/// The way the renderer is measured against, done as well as that way allows: group by group the objects are tested against the
/// frustum, those seen are copied into the frame's memory, the group's texture and buffers are bound, and one instanced draw is
/// made. What stands still was packed beforehand; what moves is packed if it is seen. It shows the same ids and colours
/// as gpu/Renderer.h, to the pixel. Vertices and indices lie in one arena and need no binding of their own: three calls a group
/// are as few as the device's interface allows.
///
/// The lists of the frame are not sorted, no triangle is culled, and only what ClassicScene allows is drawn, from the outside alone.
class ClassicPath {
public:
    /// World, and the moment's instances in number and order, must stay as they are; the device must outlive it. Errors:
    /// what ClassicScene reports.
    [[nodiscard]] static Result<std::unique_ptr<ClassicPath>>
    create(gpu::Device& device, const world::World& world, const world::DynamicState& dynamics);

    /// Draws a frame with ids, planning included. `visible` is one visit, of the outside. Errors: Driver, if memory for the
    /// frame cannot be had.
    [[nodiscard]] Result<void> render(const frame::FrameView& view, const world::DynamicState& dynamics,
                                      const visibility::VisibleSet& visible, gpu::RenderTarget& target);

    /// Of the last frame.
    struct Counts {
        std::uint32_t objects = 0; ///< drawn
        std::uint32_t draws = 0;   ///< groups of which something is drawn
    };
    [[nodiscard]] const Counts& counts() const { return counts_; }

private:
    /// Where a frame's arrays lie in its memory, bytes.
    struct Places {
        std::size_t constants = 0, blocks = 0, visit = 0, members = 0, instances = 0, commands = 0, size = 0;
    };
    /// A frustum's four sides; what is behind the eye is outside of one of them.
    struct Sides {
        Vec3 eye{0.0};
        std::array<Vec3, 4> inwards{}; ///< unit length
        [[nodiscard]] bool sees(const Sphere& bounds) const;
    };
    ClassicPath(gpu::Device& device, const world::World& world, std::unique_ptr<ClassicScene> scene);
    void layOut(const world::DynamicState& dynamics);
    [[nodiscard]] static Sides sidesOf(const visibility::View& view);
    void begin(gpu::RenderTarget& target);
    void drawGroups(const Sides& sides, const world::DynamicState& dynamics);
    [[nodiscard]] std::uint32_t gather(const ClassicGroup& group, const Sides& sides,
                                       const world::DynamicState& dynamics);
    void drawGroup(const ClassicGroup& group, std::uint32_t count);
    template <class T>
    void write(std::size_t offset, std::span<const T> values);

    gpu::Device& device_;
    const world::World& world_;
    std::unique_ptr<ClassicScene> scene_;
    world::World bare_;                     ///< the world with nothing in it,
    frame::StaticScene bareScene_;          ///< the same as a scene,
    frame::Planner planner_;                ///< and what yields its frame constants
    frame::FramePlan base_;                 ///< constants, blocks and the root visit; nothing else
    std::vector<frame::gpu::Member> zones_; ///< of what moves
    Places places_;
    ClassicScene::Storage storage_{};
    ClassicScene::Textures textures_{};
    std::span<std::byte> memory_; ///< of the frame being drawn
    Counts counts_;
};

} // namespace limen::bench
