#pragma once

#include "worlds/BuiltIn.h"

#include <string>

namespace limen::worlds::test {

enum class SurfaceKind { Shell, Exterior, Object, Portal };

/// A polygon where it stands on the map.
struct Standing {
    SurfaceKind kind = SurfaceKind::Object;
    std::string name;         ///< who it belongs to, for messages
    std::vector<Vec3> points; ///< global
    Plane plane;
    Aabb box;
    bool twoSided = false;
};

/// All polygons of buildings and cells, their furniture and what stands around them; no terrain, no scenery.
[[nodiscard]] std::vector<Standing> standingPolygons();

/// What both polygons cover, seen along the first one's normal: area in m² (0 if none) and how far the second
/// lies from the first's plane there, at most.
struct Overlap {
    double area = 0.0, apart = 0.0;
};
[[nodiscard]] Overlap overlapOf(const Standing& a, const Standing& b);

} // namespace limen::worlds::test
