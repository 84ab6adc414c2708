#pragma once

#include "worlds/records/Carve.h"
#include "worlds/records/FaceMesh.h"
#include "worlds/shapes/Panel.h"

namespace limen::worlds {

/// Walls around a space, and openings cut into them.
struct Shell {
    struct Wall {
        Polygon points; ///< convex, seen from inside
        Material material = Material::StoneWall;
    };
    std::vector<Wall> walls;
    std::vector<Polygon> openings; ///< convex, each inside one wall or touching its border; any winding
};

/// Floor, walls and ceiling of a convex footprint (z is ignored), counter-clockwise from above.
[[nodiscard]] Shell prismShell(std::span<const Vec3> footprint, double bottom, double top, Material walls);
[[nodiscard]] Shell boxShell(const Vec3& min, const Vec3& max, Material walls);
/// A U-shaped room: a box without a smaller upright box at its north side.
[[nodiscard]] Shell courtShell(const Vec3& min, const Vec3& max, const Rect& court, Material walls);

/// The walls without the openings, then a portal face for each opening, in their order. They look inwards, or
/// all of them outwards. Chooses, of several ways to cut the walls, one whose corners keep clear of each
/// other and of edges.
[[nodiscard]] std::vector<Face> facesOf(const Shell& shell, bool fromOutside = false);

} // namespace limen::worlds
