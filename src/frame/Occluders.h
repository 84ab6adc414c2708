#pragma once

#include "frame/FrameView.h"
#include "frame/StaticScene.h"
#include "visibility/OcclusionBuffer.h"
#include "visibility/Viewcone.h"

#include <vector>

namespace limen::frame {

/// Land and buildings that hide other instances from an eye outside (decision 214). They count in the root visit alone: a ray
/// that is in the root where it meets something hidden was in the root where it met the occluder.
///
/// With Occlusion::IfWorthwhile a frame in which they hide little is followed by some without them. Reuse it: steady frames allocate nothing. The scene must
/// outlive it.
class Occluders {
public:
    explicit Occluders(const StaticScene& scene) : world_(scene.world()), shapes_(scene.occluders()) {}

    /// Draws the largest occluders of a frame into the buffer, if FrameView::occlusion says so and rays begin outside. `root`: the
    /// space of the first visit; an eye just past a door begins in another space than FrameView's. `cones`: prepared for the frame.
    void prepare(const FrameView& frame, world::SpaceIndex root, const visibility::Viewcones& cones);
    [[nodiscard]] bool areReady() const { return areReady_; } ///< for this frame
    /// Whether no part of a sphere shows in the root visit. False if they are not ready.
    [[nodiscard]] bool hide(const visibility::SeenSphere& sphere) const {
        return areReady_ && buffer_.hides({sphere.centre, sphere.radius + sphere.tolerance});
    }
    /// Whether no part of a static instance shows there. `position`: of Clusters::order.
    [[nodiscard]] bool hideAt(std::uint32_t position) const {
        if (!areReady_)
            return false;
        const OccluderShapes::Box box = shapes_.box(position);
        return buffer_.hidesBox(box.centre - eye_, box.half);
    }
    /// Ends a frame: the number of instances that are drawn, and of those that are hidden.
    void finish(std::uint32_t drawn, std::uint32_t hidden);

private:
    struct Seen {
        double size = 0.0; ///< radius by distance
        std::uint32_t occluder = 0;
    };
    void cover(const OccluderShapes::Occluder& occluder);

    const world::World& world_;
    const OccluderShapes& shapes_;
    Vec3 eye_{0.0};
    std::vector<Seen> seen_;
    std::vector<Vec3> corners_; ///< of a shape, eye-relative
    visibility::OcclusionBuffer buffer_;
    bool areReady_ = false;
    std::uint32_t pause_ = 0; ///< frames without them that are to come
};

} // namespace limen::frame
