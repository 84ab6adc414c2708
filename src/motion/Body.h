#pragma once

#include "motion/Collisions.h"

namespace limen::motion {

/// How a body is built and moves; metres and seconds.
struct BodyShape {
    Capsule capsule;
    double eyeHeight = 1.7;  ///< above the feet
    double stepUp = 0.6;     ///< it climbs what is no higher
    double stepDown = 0.6;   ///< and keeps to ground that falls away by no more in a step
    double steepest = 0.664; ///< upward part of the normal of ground that it can stand on
    double walkSpeed = 2.2, runSpeed = 5.0;
    double jumpSpeed = 4.2; ///< upwards: 0.9 m high
    double gravity = 9.81;
};

/// What a body is asked to do.
struct BodyInput {
    double forward = 0.0, right = 0.0; ///< -1..1 each, level
    double yaw = 0.0;                  ///< compass direction that forward is, degrees
    bool run = false;
    bool jump = false; ///< if it stands
};

struct BodyState {
    Standing standing;
    Vec3 velocity{0.0}; ///< metres a second
    bool isOnGround = false;
    Standing safe;                ///< where it stood last
    std::uint32_t recoveries = 0; ///< how often it fell out of the world, and was put back there
};

/// A body that is put somewhere.
[[nodiscard]] BodyState bodyAt(const Standing& standing);

/// A body a while later: a pure function, whose steps do not depend on frames longer than 17 ms being cut otherwise. It slides along
/// what it bumps into, climbs steps, falls, and keeps track of the space its middle is in. One that falls below everything is put back
/// where it stood last. `doors`: as in Collisions::sweep.
[[nodiscard]] BodyState moved(const BodyState& body, const BodyInput& input, double seconds,
                              const Collisions& around, std::span<const double> doors,
                              const BodyShape& shape = {});

/// A body that something moves aside, by `way` metres on the level: along what is in the way, and up and down steps, as if it walked, but
/// at once. What it overlaps is left in no other direction than `way`.
[[nodiscard]] BodyState shoved(const BodyState& body, const Vec3& way, const Collisions& around,
                               std::span<const double> doors, const BodyShape& shape = {});

/// The eye of a body, and the space that is in.
struct BodyEye {
    Vec3 position{0.0};
    world::SpaceIndex space = world::kOutside;
};
[[nodiscard]] BodyEye eyeOf(const BodyState& body, const world::World& world, const BodyShape& shape = {});

} // namespace limen::motion
