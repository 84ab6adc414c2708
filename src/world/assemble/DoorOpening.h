#pragma once

#include "world/World.h"

#include <optional>

namespace limen::world {

/// The box around a shut door, global.
struct DoorBox {
    Vec3 centre{0.0};
    std::array<Vec3, 3> axes{}; ///< unit vectors, perpendicular
    Vec3 half{0.0};             ///< metres along the axes; not negative
};

/// The opening that a door stands before, and the way from the middle of its box to the portal's plane.
struct DoorOpening {
    PortalIndex portal = kNone; ///< from a cell, if one side of the opening is a cell
    Vec3 way{0.0};
};

/// Finds the portal that a door fills: its polygon is within 0.5 m of the middle of the box and at most 20 degrees from the
/// plane of its two larger sides, and covers at least half of the box's face and two fifths of its own. Among several the
/// nearest is chosen, then the lowest index. None: the door stands before no opening.
[[nodiscard]] std::optional<DoorOpening> findOpening(const World& world, const DoorBox& box);

/// The share of a portal's polygon that triangles cover, seen along its normal: 0..1, from about 200 points.
/// `corners`: three global points for each triangle.
[[nodiscard]] double coveredShare(const World& world, const Portal& portal, std::span<const Vec3> corners);

} // namespace limen::world
