#include "support/TestShapes.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>

namespace limen::test {

Walls boxWalls(const Vec3& min, const Vec3& max, const std::string& surface) {
    const auto corner = [&](int x, int y, int z) {
        return Vec3(x ? max.x : min.x, y ? max.y : min.y, z ? max.z : min.z);
    };
    Walls walls(6);
    walls[kFloor].points = {corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0)};
    walls[kCeiling].points = {corner(0, 0, 1), corner(0, 1, 1), corner(1, 1, 1), corner(1, 0, 1)};
    walls[kSouth].points = {corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 1), corner(1, 0, 0)};
    walls[kNorth].points = {corner(0, 1, 0), corner(1, 1, 0), corner(1, 1, 1), corner(0, 1, 1)};
    walls[kWest].points = {corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1), corner(0, 0, 1)};
    walls[kEast].points = {corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 1), corner(1, 1, 0)};
    for (Wall& wall : walls)
        wall.surface = surface;
    return walls;
}

Walls insideOut(Walls walls) {
    for (Wall& wall : walls)
        std::reverse(wall.points.begin(), wall.points.end());
    return walls;
}

std::vector<Vec3> rectangle(const Vec3& a, const Vec3& b) {
    if (a.x == b.x)
        return {a, {a.x, b.y, a.z}, b, {a.x, a.y, b.z}};
    if (a.y == b.y)
        return {a, {b.x, a.y, a.z}, b, {a.x, a.y, b.z}};
    return {a, {b.x, a.y, a.z}, b, {a.x, b.y, a.z}};
}

std::vector<Vec3> regularPolygon(const Vec3& centre, const Vec3& normal, double radius, int count) {
    const Vec3 n = glm::normalize(normal);
    const Vec3 helper = std::abs(n.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const Vec3 u = glm::normalize(glm::cross(helper, n));
    const Vec3 v = glm::cross(n, u);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * 3.14159265358979323846 * (i + 0.5) / count;
        points.push_back(centre + u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)));
    }
    return points;
}

namespace {

bool coplanar(const Wall& wall, std::span<const Vec3> opening) {
    const Plane plane = planeOf(wall.points);
    return glm::dot(plane.n, plane.n) > 0.0 &&
           std::all_of(opening.begin(), opening.end(),
                       [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) < 1e-3; });
}

/// The remainder of one wall: clipped edge by edge; the last part is the opening itself.
void subtract(const Wall& wall, std::span<const Vec3> opening, Walls& out) {
    const Vec3 normal = planeOf(wall.points).n;
    const double turn = glm::dot(newellNormal(opening), normal) > 0.0 ? 1.0 : -1.0;
    std::vector<Vec3> rest = wall.points, piece;
    for (std::size_t i = 0; i < opening.size() && !rest.empty(); ++i) {
        const Vec3 edge = opening[(i + 1) % opening.size()] - opening[i];
        const Vec3 inward = glm::normalize(glm::cross(normal, edge)) * turn;
        const Plane plane{inward, -glm::dot(inward, opening[i])};
        clipPolygon(rest, plane.flipped(), 0.0, piece);
        if (glm::length(newellNormal(piece)) > 1e-9)
            out.push_back({piece, wall.surface, wall.twoSided});
        clipPolygon(rest, plane, 0.0, piece);
        rest = glm::length(newellNormal(piece)) > 1e-9 ? piece : std::vector<Vec3>{};
    }
}

} // namespace

Vec3 cutOpening(Walls& walls, std::span<const Vec3> opening) {
    Vec3 normal(0.0);
    Walls result;
    for (const Wall& wall : walls) {
        if (!coplanar(wall, opening)) {
            result.push_back(wall);
            continue;
        }
        const std::size_t before = result.size();
        subtract(wall, opening, result);
        const bool untouched =
            result.size() == before + 1 && result.back().points.size() == wall.points.size() &&
            glm::length(newellNormal(result.back().points) - newellNormal(wall.points)) < 1e-9;
        if (!untouched)
            normal = planeOf(wall.points).n;
    }
    walls = std::move(result);
    return normal;
}

} // namespace limen::test
