#pragma once

#include "worlds/BuiltIn.h"

#include <string>

namespace limen::worlds::test {

enum class SurfaceKind { Shell, Exterior, Object, Portal };

/// A polygon of a placed model or cell.
struct Standing {
    SurfaceKind kind = SurfaceKind::Object;
    std::string name;         ///< its owner, for messages
    std::vector<Vec3> points; ///< global
    Plane plane;
    Aabb box;
    bool twoSided = false;
};

/// All polygons of buildings, cells, furniture and outdoor props, without terrain and scenery.
[[nodiscard]] std::vector<Standing> standingPolygons();

/// The overlap of two polygons, seen along the first one's normal: its area in m² (0 if none), and the
/// greatest distance (metres) of the second from the first one's plane there.
struct Overlap {
    double area = 0.0, apart = 0.0;
};
[[nodiscard]] Overlap overlapOf(const Standing& a, const Standing& b);

} // namespace limen::worlds::test
