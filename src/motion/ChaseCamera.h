#pragma once

#include "motion/Body.h"

namespace limen::motion {

/// Dimensions of a third-person camera; metres and seconds.
struct ChaseShape {
    double distance = 3.0; ///< behind the head, where the way is free
    double rise = 0.4;     ///< above that, where the way is free
    double radius =
        0.25; ///< of the sphere that keeps the camera off obstacles; at most the body's radius is used
    double quick = 4.0;    ///< a second: rate of the exponential return after an obstacle
    double still = 0.0005; ///< this near to its goal the camera is moved onto it
};

/// The lengths of a chase camera's way, and its eye.
struct ChaseState {
    double arm = 0.0;  ///< metres behind the head
    double lift = 0.0; ///< metres above that
    BodyEye eye;
};

/// The camera `seconds` later; a pure function. A sphere is swept from the body's middle to its head, then
/// backwards, then up, so it overlaps nothing, and its space is the end of that way. An obstacle shortens the
/// way at once; afterwards the way grows back smoothly until it is exactly at its goal. `forward`: unit
/// vector of the gaze. `headRise`: metres added to the head's height (it climbs steps smoothly). `doors`: as
/// in Collisions::sweep.
[[nodiscard]] ChaseState chased(const ChaseState& before, const BodyState& body, const Vec3& forward,
                                double seconds, const Collisions& around, std::span<const double> doors,
                                double headRise = 0.0, const BodyShape& bodyShape = {},
                                const ChaseShape& shape = {});

} // namespace limen::motion
