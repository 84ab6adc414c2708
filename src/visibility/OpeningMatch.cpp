#include "visibility/OpeningMatch.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace limen::visibility {

namespace {

bool isSame(std::span<const Vec3> a, std::span<const Vec3> b, double tolerance) {
    if (a.size() != b.size())
        return false;
    const std::size_t count = a.size();
    const auto agreesFrom = [&](std::size_t shift) {
        for (std::size_t i = 0; i < count; ++i)
            if (glm::length(a[i] - b[(shift + count - i) % count]) > tolerance)
                return false;
        return true;
    };
    for (std::size_t shift = 0; shift < count; ++shift)
        if (agreesFrom(shift))
            return true;
    return false;
}

bool isInPlane(std::span<const Vec3> polygon, const Plane& plane, double tolerance) {
    for (const Vec3& corner : polygon)
        if (std::abs(plane.signedDistance(corner)) > tolerance)
            return false;
    return true;
}

/// The part of `a` inside the upright prism over `b`.
double overlapOf(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& normalOfB) {
    std::vector<Vec3> part(a.begin(), a.end()), next;
    for (std::size_t i = 0; i < b.size(); ++i) {
        const Vec3 inwards = glm::cross(normalOfB, b[(i + 1) % b.size()] - b[i]);
        const double length = glm::length(inwards);
        if (length == 0.0)
            continue;
        const Vec3 n = inwards / length;
        clipPolygon(part, {n, -glm::dot(n, b[i])}, 0.0, next);
        part.swap(next);
    }
    return glm::length(newellNormal(part)) / 2.0;
}

double perimeterOf(std::span<const Vec3> polygon) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += glm::length(polygon[(i + 1) % polygon.size()] - polygon[i]);
    return sum;
}

} // namespace

OpeningMatch matchOpenings(std::span<const Vec3> a, std::span<const Vec3> b, double tolerance) {
    const Plane planeOfA = planeOf(a), planeOfB = planeOf(b);
    if (glm::dot(planeOfA.n, planeOfB.n) >= 0.0)
        return {};
    if (isSame(a, b, tolerance))
        return {OpeningMatch::Kind::Same, glm::length(newellNormal(a)) / 2.0};
    if (!isInPlane(a, planeOfB, tolerance) || !isInPlane(b, planeOfA, tolerance))
        return {};
    const double area = overlapOf(a, b, planeOfB.n);
    if (area <= tolerance * perimeterOf(a))
        return {};
    return {OpeningMatch::Kind::Overlap, area};
}

bool overlapsInPlane(std::span<const Vec3> polygon, std::span<const Vec3> opening, const Plane& plane,
                     double inPlane, double overlap) {
    return isInPlane(polygon, plane, inPlane) &&
           overlapOf(polygon, opening, plane.n) >
               overlap * std::min(perimeterOf(polygon), perimeterOf(opening));
}

void sortBestFirst(std::vector<PairProposal>& proposals) {
    std::sort(proposals.begin(), proposals.end(), [](const PairProposal& x, const PairProposal& y) {
        if (x.match.kind != y.match.kind)
            return x.match.kind > y.match.kind;
        if (x.match.kind == OpeningMatch::Kind::Overlap && x.match.area != y.match.area)
            return x.match.area > y.match.area;
        return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
}

} // namespace limen::visibility
