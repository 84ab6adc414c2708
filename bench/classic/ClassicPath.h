#pragma once

#include "ClassicScene.h"
#include "FrustumSides.h"
#include "frame/Planner.h"
#include "gpu/RenderTarget.h"

namespace limen::bench {

/// The classic path of drawing, a fair baseline for the renderer. For each group it tests the objects against
/// the frustum and their levels of detail, copies the visible ones into the frame's memory, binds the group's texture and buffers, and
/// issues one instanced draw. Static objects are packed beforehand, dynamic ones when they are visible. All
/// pixels have the same ids and colours as those of gpu/Renderer.h. Vertices and indices are in one arena
/// without bindings of their own, so three calls a group are the minimum of the device's interface.
///
/// It does not sort, culls no triangles, and draws only worlds that ClassicScene accepts, from the outside.
class ClassicPath {
public:
    /// The world, and the number and order of the dynamic instances, must not change. The device must outlive
    /// it. Errors: those of ClassicScene.
    [[nodiscard]] static Result<std::unique_ptr<ClassicPath>>
    create(gpu::Device& device, const world::World& world, const world::DynamicState& dynamics);

    /// Plans and draws a frame with ids. `visible` must be one visit, the outside. Errors: Driver, if there
    /// is no memory for the frame.
    [[nodiscard]] Result<void> render(const frame::FrameView& view, const world::DynamicState& dynamics,
                                      const visibility::VisibleSet& visible, gpu::RenderTarget& target);

    /// Counts of the last frame.
    struct Counts {
        std::uint32_t objects = 0; ///< drawn
        std::uint32_t draws = 0;   ///< draw calls: groups with a visible object
    };
    [[nodiscard]] const Counts& counts() const { return counts_; }

private:
    /// Offsets of a frame's arrays in its memory, in bytes.
    struct Places {
        std::size_t constants = 0, blocks = 0, visit = 0, members = 0, instances = 0, commands = 0, size = 0;
    };
    ClassicPath(gpu::Device& device, const world::World& world, std::unique_ptr<ClassicScene> scene);
    void layOut(const world::DynamicState& dynamics);
    void begin(gpu::RenderTarget& target);
    void drawGroups(const FrustumSides& sides, const world::DynamicState& dynamics);
    [[nodiscard]] std::uint32_t gather(const ClassicGroup& group, const FrustumSides& sides,
                                       const world::DynamicState& dynamics);
    /// Whether the eye's distance is in an object's range.
    [[nodiscard]] bool isInRange(const world::Instance& instance) const {
        return world::isInLevelRange(world_, instance, eye_);
    }
    void drawGroup(const ClassicGroup& group, std::uint32_t count);
    template <class T>
    void write(std::size_t offset, std::span<const T> values);

    gpu::Device& device_;
    const world::World& world_;
    std::unique_ptr<ClassicScene> scene_;
    world::World bare_;                     ///< the world without instances, for planner_
    frame::StaticScene bareScene_;          ///< the same as a scene,
    frame::Planner planner_;                ///< makes the frame constants
    frame::FramePlan base_;                 ///< constants, blocks and the root visit; nothing else
    std::vector<frame::gpu::Member> zones_; ///< members of the dynamic instances
    Places places_;
    ClassicScene::Storage storage_{};
    ClassicScene::Textures textures_{};
    std::span<std::byte> memory_; ///< of the frame being drawn
    Counts counts_;
    world::RangeSteps eye_; ///< of the frame being drawn
};

} // namespace limen::bench
