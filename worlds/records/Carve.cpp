#include "worlds/records/Carve.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>
#include <tuple>

namespace limen::worlds {

namespace {

/// Square metres. Smaller parts are rounding errors.
constexpr double kNoArea = 1e-7;

Vec3 crossing(Vec3 a, Vec3 b, const Plane& plane) {
    if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z))
        std::swap(a, b);
    const double da = plane.signedDistance(a);
    const double db = plane.signedDistance(b);
    return a + (b - a) * (da / (da - db));
}

/// The plane through an edge, perpendicular to the polygon, which is in front of it.
Plane edgePlane(const Vec3& a, const Vec3& b, const Vec3& normal) {
    const Vec3 n = glm::normalize(glm::cross(normal, b - a));
    return {n, -glm::dot(n, a)};
}

void dropIfFlat(Polygon& polygon) {
    if (polygon.size() < 3 || areaOf(polygon) < kNoArea)
        polygon.clear();
}

} // namespace

Halves splitPolygon(std::span<const Vec3> polygon, const Plane& plane) {
    Halves out;
    const auto side = [&](const Vec3& p) {
        const double d = plane.signedDistance(p);
        return d > kOnCut ? 1 : d < -kOnCut ? -1 : 0;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& a = polygon[i];
        const Vec3& b = polygon[(i + 1) % polygon.size()];
        const int sa = side(a);
        const int sb = side(b);
        if (sa >= 0)
            out.front.push_back(a);
        if (sa <= 0)
            out.back.push_back(a);
        if (sa * sb < 0) {
            const Vec3 cut = crossing(a, b, plane);
            out.front.push_back(cut);
            out.back.push_back(cut);
        }
    }
    dropIfFlat(out.front);
    dropIfFlat(out.back);
    return out;
}

Polygon commonPart(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& normal) {
    Polygon rest(a.begin(), a.end());
    for (std::size_t i = 0; i < b.size() && !rest.empty(); ++i)
        rest = splitPolygon(rest, edgePlane(b[i], b[(i + 1) % b.size()], normal)).front;
    return rest;
}

std::vector<Polygon> withoutOpenings(const Polygon& wall, std::span<const Polygon> openings) {
    const Vec3 normal = planeOf(wall).n;
    std::vector<Polygon> pieces{wall};
    for (const Polygon& given : openings) {
        Polygon opening = given;
        if (glm::dot(newellNormal(opening), normal) < 0.0)
            std::reverse(opening.begin(), opening.end());
        std::vector<Polygon> left;
        for (Polygon& piece : pieces) {
            if (commonPart(piece, opening, normal).empty()) {
                left.push_back(std::move(piece));
                continue;
            }
            Polygon rest = std::move(piece);
            for (std::size_t i = 0; i < opening.size() && !rest.empty(); ++i) {
                Halves halves =
                    splitPolygon(rest, edgePlane(opening[i], opening[(i + 1) % opening.size()], normal));
                if (!halves.back.empty())
                    left.push_back(std::move(halves.back));
                rest = std::move(halves.front);
            }
        }
        pieces = std::move(left);
    }
    return pieces;
}

Polygon facing(Polygon polygon, const Vec3& inside) {
    if (planeOf(polygon).signedDistance(inside) < 0.0)
        std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

double areaOf(std::span<const Vec3> polygon) {
    return 0.5 * glm::length(newellNormal(polygon));
}

Vec3 centroidOf(std::span<const Vec3> polygon) {
    const Vec3 normal = newellNormal(polygon);
    Vec3 sum(0.0);
    double weight = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const double w = glm::dot(glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]), normal);
        sum += (polygon[0] + polygon[i] + polygon[i + 1]) * (w / 3.0);
        weight += w;
    }
    return sum / weight;
}

double edgeDistance(std::span<const Vec3> polygon, const Vec3& point) {
    const Vec3 normal = planeOf(polygon).n;
    double nearest = 1e300;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        nearest = std::min(
            nearest, edgePlane(polygon[i], polygon[(i + 1) % polygon.size()], normal).signedDistance(point));
    }
    return nearest;
}

} // namespace limen::worlds
