#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <array>
#include <span>

namespace limen::world {

inline constexpr double kLandcellSize = 24.0; ///< side, metres

/// True if a landcell of a block is cut from south-west to north-east, else from south-east to north-west.
[[nodiscard]] bool splitsSouthWestNorthEast(dat::BlockCoord block, int cellX, int cellY);

/// A corner of a landcell, as steps from its south-west corner.
struct LandcellCorner {
    int x, y;
};
/// The two triangles of a landcell, counter-clockwise seen from above.
using LandcellTriangles = std::array<std::array<LandcellCorner, 3>, 2>;
[[nodiscard]] LandcellTriangles landcellTriangles(bool southWestNorthEast);

/// Height and upward unit normal of the ground's triangle under a block-local position.
struct GroundPoint {
    double z = 0.0;
    Vec3 normal{0.0, 0.0, 1.0};
};
/// `heights`: 81, as in Block::heights. Positions outside 0..192 m are clamped into it.
[[nodiscard]] GroundPoint groundAt(dat::BlockCoord block, std::span<const float> heights, double x, double y);

} // namespace limen::world
