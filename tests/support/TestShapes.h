#pragma once

#include "geometry/Plane.h"
#include "geometry/Vec.h"

#include <span>
#include <string>
#include <vector>

// Walls, boxes and openings for worlds that tests build. Units: metres, in any one frame.
namespace limen::test {

/// A flat convex polygon, counter-clockwise seen from its visible side.
struct Wall {
    std::vector<Vec3> points;
    std::string surface = "grey"; ///< name given to TestWorld::solid or ::picture; "" draws nothing
    bool twoSided = false;
};
using Walls = std::vector<Wall>;

/// Indices into the result of boxWalls.
enum BoxWall { kFloor, kCeiling, kSouth, kNorth, kWest, kEast };

/// The six walls of a box, seen from inside, in the order of BoxWall.
[[nodiscard]] Walls boxWalls(const Vec3& min, const Vec3& max, const std::string& surface = "grey");

/// The same walls seen from the other side: a solid block.
[[nodiscard]] Walls insideOut(Walls walls);

/// An axis-aligned rectangle from two opposite corners that agree in exactly one coordinate.
[[nodiscard]] std::vector<Vec3> rectangle(const Vec3& a, const Vec3& b);

/// A regular polygon of `count` corners around `centre`, in the plane with normal `normal`.
[[nodiscard]] std::vector<Vec3> regularPolygon(const Vec3& centre, const Vec3& normal, double radius,
                                               int count);

/// Cuts a convex opening out of every wall in its plane (within 1 mm). The pieces meet at T-junctions, as in
/// artists' models. Yields the normal of a wall that was cut, zero if none was.
Vec3 cutOpening(Walls& walls, std::span<const Vec3> opening);

} // namespace limen::test
