#pragma once

#include "motion/Collisions.h"

namespace limen::motion {

/// Dimensions and abilities of a body; metres and seconds.
struct BodyShape {
    Capsule capsule;
    double eyeHeight = 1.7;  ///< above the feet
    double stepUp = 0.6;     ///< the highest step that a body climbs
    double stepDown = 0.6;   ///< a walking body follows ground that falls by no more than this in a step
    double steepest = 0.664; ///< least upward part of the normal of ground that a body can stand on
    double walkSpeed = 2.2, runSpeed = 5.0;
    double jumpSpeed = 4.2; ///< upwards: 0.9 m high
    double gravity = 9.81;
};

/// The player's wish for one step.
struct BodyInput {
    double forward = 0.0, right = 0.0; ///< -1..1 each, level
    double yaw = 0.0;                  ///< compass direction of forward, degrees
    bool run = false;
    bool jump = false; ///< has an effect on the ground only
};

struct BodyState {
    Standing standing;
    Vec3 velocity{0.0}; ///< metres a second
    bool isOnGround = false;
    Standing safe;                ///< the last position on the ground
    std::uint32_t recoveries = 0; ///< falls out of the world, each of which ended at `safe`
};

/// A body in the air at a position, without velocity.
[[nodiscard]] BodyState bodyAt(const Standing& standing);

/// The body `seconds` later. A pure function; time is cut into equal steps of at most 17 ms. The body slides
/// along obstacles, climbs steps and falls; its space is tracked. A body that falls below everything returns
/// to its last position on the ground. `doors`: as in Collisions::sweep.
[[nodiscard]] BodyState moved(const BodyState& body, const BodyInput& input, double seconds,
                              const Collisions& around, std::span<const double> doors,
                              const BodyShape& shape = {});

/// The body after a push of `way` metres on the level. It moves at once, along obstacles and over steps as if
/// it walked, and leaves overlaps in the direction of `way` only. `doors`: as in Collisions::sweep.
[[nodiscard]] BodyState shoved(const BodyState& body, const Vec3& way, const Collisions& around,
                               std::span<const double> doors, const BodyShape& shape = {});

/// The eye of a body and the space that the eye is in.
struct BodyEye {
    Vec3 position{0.0}; ///< global
    world::SpaceIndex space = world::kOutside;
};
[[nodiscard]] BodyEye eyeOf(const BodyState& body, const world::World& world, const BodyShape& shape = {});

} // namespace limen::motion
