#pragma once

#include "motion/DynamicInstances.h"

// Meshes that turn to the eye (docs/ray-rule.md#levels-of-detail). They are turned here, once for each state,
// so that the drawing and the reference see the same pose.
namespace limen::motion {

/// An object as the eye sees it: its distance for levels of detail, and the direction that its billboards face
/// away from.
class ObjectView {
public:
    /// Positions: global. `isOutdoors`: the object is in a landcell. `levels`: of its range.
    ObjectView(const Vec3& eye, const Vec3& origin, bool isOutdoors, const world::LevelShare& levels);

    [[nodiscard]] bool isIn(const world::LevelRange& range) const { return range.contains(squared_); }
    /// The unit vector from the eye. One for all parts of an object, unless the eye is near it; then that
    /// towards the middle of the part.
    [[nodiscard]] Vec3 headingTo(const Vec3& partMiddle) const;

private:
    Vec3 eye_, target_;
    bool isShared_ = false;     ///< `target_` is for all parts
    std::uint32_t squared_ = 0; ///< steps, as LevelShare::seen
};

/// Turns the frame of a mesh so that it faces away from `heading`, a unit vector. `linear`: world from model
/// space; its columns are the axes of the mesh, each as long as the scale.
[[nodiscard]] Mat3 turnedToEye(world::Facing facing, const Mat3& linear, const Vec3& heading);

/// Turns an instance of a dynamic state, if its mesh turns to the eye.
void turnToEye(const ObjectView& view, const world::World& world, world::Instance& instance);

/// Appends the static billboards that the eye is in range of.
void addBillboards(DynamicInstances& instances);

} // namespace limen::motion
