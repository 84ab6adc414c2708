#pragma once

#include "motion/Body.h"

namespace limen::motion {

/// How a camera follows a body; metres and seconds.
struct ChaseShape {
    double distance = 3.0; ///< that it would like to be behind the head
    double rise = 0.4;     ///< that it would like to be above that
    double radius = 0.25;  ///< kept from all that a body bumps into; no more than a body's own
    double quick = 4.0;    ///< a second: how fast it comes away from what it was pushed in by
    double still = 0.0005; ///< so near to where it belongs it is there
};

/// Where a chase camera is.
struct ChaseState {
    double arm = 0.0;  ///< metres behind the head
    double lift = 0.0; ///< metres above that
    BodyEye eye;
};

/// The camera a while later: a ball that is swept from within the body to its head, behind that, and up, so that it is in nothing, and
/// its space is the one that the way leads to, through whatever openings. What is in the way pushes it in at once; it comes out again by and
/// by, and then rests to the bit. A pure function. `forward`: where it looks, a unit vector; `headRise`: metres that the head is
/// above where it belongs (it climbs steps smoothly); `doors`: as in Collisions::sweep.
[[nodiscard]] ChaseState chased(const ChaseState& before, const BodyState& body, const Vec3& forward,
                                double seconds, const Collisions& around, std::span<const double> doors,
                                double headRise = 0.0, const BodyShape& bodyShape = {},
                                const ChaseShape& shape = {});

} // namespace limen::motion
