#pragma once

#include "motion/Body.h"

#include <vector>

namespace limen::motion {

/// Corners of a way on foot around obstacles, from a body to a point near it.
struct Detour {
    std::vector<Vec3> corners; ///< positions of the feet, global; the last is the point, or the nearest to it
    bool reaches = false;      ///< the last corner is the point
};

/// Searches squares within 8 m of the body (A*); `square` is their side in metres. A square counts as reached if a copy of the body walks
/// there, so steps, slopes and doors are judged as `moved` judges them. Doors do not move. Empty if `to`
/// is farther than 8 m on the level. Cost: up to a second. `doors`: as in Collisions::sweep.
[[nodiscard]] Detour wayAround(const BodyState& body, const Vec3& to, double square, const Collisions& around,
                               std::span<const double> doors, const BodyShape& shape = {});

} // namespace limen::motion
