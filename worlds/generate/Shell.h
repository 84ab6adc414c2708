#pragma once

#include "worlds/Mesh.h"
#include "worlds/Panel.h"
#include "worlds/generate/Carve.h"

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
/// A box without a smaller upright one that reaches in from its north side: a room in the shape of a U.
[[nodiscard]] Shell courtShell(const Vec3& min, const Vec3& max, const Rect& court, Material walls);

/// The walls without the openings, and a portal face for each opening, in their order; seen from inside, or all seen
/// from outside. Of several ways to cut the walls, one whose corners stay clear of each other and of edges.
[[nodiscard]] std::vector<Face> facesOf(const Shell& shell, bool fromOutside = false);

} // namespace limen::worlds
