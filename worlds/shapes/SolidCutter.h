#pragma once

#include "worlds/records/Carve.h"
#include "worlds/shapes/Panel.h"
#include "worlds/shapes/Random.h"

#include <cstdint>

namespace limen::worlds {

/// A convex polyhedron whose sides look inwards.
struct Solid {
    struct Side {
        Polygon points;
        /// The number of its plane: 0..5 are the box (west, east, south, north, floor, ceiling), then the
        /// cuts in order.
        std::int32_t cut = 0;
    };
    std::vector<Side> sides;
};

/// Cuts a box into `count` >= 1 convex solids by planes, two of three tilted. No corner of a solid is near a
/// plane that cuts it, so edges are at least some centimetres long.
[[nodiscard]] std::vector<Solid> cutBox(const Vec3& min, const Vec3& max, std::uint32_t count,
                                        Random& random);

/// A part of a plane that two solids share.
struct SharedFace {
    std::uint32_t first = 0, second = 0; ///< solids, the first in front of the cut
    std::uint32_t firstSide = 0, secondSide = 0;
    Polygon points; ///< seen from the first
};
/// All shared faces that contain a circle of `leastRadius` around their centre, in a fixed order.
[[nodiscard]] std::vector<SharedFace> sharedFaces(const std::vector<Solid>& solids, double leastRadius);

[[nodiscard]] Vec3 middleOf(const Solid& solid);

} // namespace limen::worlds
