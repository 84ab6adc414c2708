#pragma once

#include "dat/records/Models.h"
#include "geometry/Vec.h"

namespace limen::world {

/// A frame of a record as unit quaternion and finite origin, in metres. The default is the identity.
struct Pose {
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    Vec3 origin{0.0};
    [[nodiscard]] Vec3 apply(const Vec3& p) const { return origin + orientation * p; }
    /// The pose in this frame of a pose that is relative to it.
    [[nodiscard]] Pose of(const Pose& inner) const {
        return {orientation * inner.orientation, apply(inner.origin)};
    }
};

/// An orientation that cannot be normalised becomes the identity; an origin that is not finite becomes zero.
[[nodiscard]] Pose poseOf(const dat::Frame& frame);

/// The frames of the pose for static display: the resting placement, else the default one. Null without both.
[[nodiscard]] const dat::AnimationFrame* restingPose(const dat::Setup& setup);

/// The resting pose of a part of a Setup, in the object's frame; the identity for parts that no placement
/// frame has.
[[nodiscard]] Pose restOf(const dat::Setup& setup, std::size_t part);

/// The pose of a part in one placement of a Setup, else in the default placement; else the identity.
[[nodiscard]] Pose placedPartOf(const dat::Setup& setup, std::uint32_t placement, std::size_t part);

} // namespace limen::world
