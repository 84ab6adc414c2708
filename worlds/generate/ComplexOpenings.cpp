#include "worlds/generate/ComplexOpenings.h"

#include "geometry/Angles.h"
#include "geometry/Segment.h"

#include <algorithm>

namespace limen::worlds {

namespace {

constexpr double kSliver = 0.01;    ///< metres
constexpr double kLeastArea = 0.02; ///< square metres of each part that a line cuts

struct Axes {
    Vec3 u, v, n;
};

Axes axesOf(const Polygon& face) {
    Axes axes;
    axes.n = planeOf(face).n;
    axes.u = glm::normalize(face[1] - face[0]);
    axes.v = glm::cross(axes.n, axes.u);
    return axes;
}

/// A random line through a point of the face's plane, as a plane perpendicular to the face.
Plane randomLine(const Polygon& face, const Vec3& through, Random& random) {
    const Axes axes = axesOf(face);
    const double a = kTurn * random.unit();
    const Vec3 n = axes.u * std::cos(a) + axes.v * std::sin(a);
    return {n, -glm::dot(n, through)};
}

bool staysClear(const Polygon& polygon, const Plane& plane) {
    constexpr double kClearOfOpening = 0.02;
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) > kClearOfOpening; });
}

/// Both parts of a polygon cut by a line that keeps clear of its corners, or nothing.
Halves halvesOf(const Polygon& polygon, Random& random) {
    for (int attempt = 0; attempt < 20; ++attempt) {
        const Plane line = randomLine(polygon, centroidOf(polygon), random);
        if (!staysClear(polygon, line))
            continue;
        Halves halves = splitPolygon(polygon, line);
        if (areaOf(halves.front) > kLeastArea && areaOf(halves.back) > kLeastArea)
            return halves;
    }
    return {};
}

Polygon sliverOpening(const Polygon& face, Random& random) {
    const Vec3 middle = centroidOf(face);
    const double length = 0.8 * edgeDistance(face, middle);
    const Axes axes = axesOf(face);
    const double a = kTurn * random.unit();
    const Vec3 along = (axes.u * std::cos(a) + axes.v * std::sin(a)) * length;
    const Vec3 across = glm::normalize(glm::cross(axes.n, along)) * (kSliver / 2);
    return {middle - along - across, middle + along - across, middle + along + across,
            middle - along + across};
}

Polygon shifted(Polygon polygon, const Polygon& face, Random& random) {
    const Axes axes = axesOf(face);
    const double a = kTurn * random.unit();
    const Vec3 by = (axes.u * std::cos(a) + axes.v * std::sin(a)) * random.between(0.012, 0.04);
    for (Vec3& p : polygon)
        p += by;
    return polygon;
}

/// True if the distance is zero up to rounding, or large.
bool isClear(double distance) {
    constexpr double kOn = 1e-6, kAway = 0.01;
    return distance < kOn || distance > kAway;
}

bool clearOf(const Polygon& a, const Polygon& b) {
    return std::all_of(a.begin(), a.end(), [&](const Vec3& p) {
        for (std::size_t i = 0; i < b.size(); ++i) {
            const Vec3& from = b[i];
            if (!isClear(glm::length(p - from)) ||
                !isClear(distanceToSegment(p, from, b[(i + 1) % b.size()]).distance))
                return false;
        }
        return true;
    });
}

/// True if its corners are on the edges of the walls or clear of them.
bool clean(const Polygon& polygon, std::span<const Polygon> walls) {
    constexpr std::size_t kMostCorners = 12;
    return !polygon.empty() && polygon.size() <= kMostCorners && clearOf(polygon, polygon) &&
           std::all_of(walls.begin(), walls.end(),
                       [&](const Polygon& wall) { return clearOf(polygon, wall) && clearOf(wall, polygon); });
}

bool fits(const Polygon& polygon, const Polygon& face) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const Vec3& p) { return edgeDistance(face, p) > 0.01; });
}

} // namespace

Polygon roundOpening(const Polygon& face, Random& random) {
    const Vec3 middle = centroidOf(face);
    const Axes axes = axesOf(face);
    const double radius = edgeDistance(face, middle) * random.between(0.45, 0.9);
    const std::uint32_t corners = 3 + random.below(10);
    const double begin = kTurn * random.unit();
    Polygon out;
    for (std::uint32_t k = 0; k < corners; ++k) {
        // Each corner keeps to the middle third of its share of the circle, so no two are near each other.
        const double a = begin + kTurn * (k + random.between(-0.17, 0.17)) / corners;
        out.push_back(middle + axes.u * (radius * std::cos(a)) + axes.v * (radius * std::sin(a)));
    }
    return out;
}

std::vector<OpeningPair> makeOpenings(const Polygon& face, std::span<const Polygon> walls,
                                      const OpeningMix& mix, Random& random) {
    const double pick = random.unit();
    if (pick < mix.slivers) {
        const Polygon sliver = sliverOpening(face, random);
        return {{sliver, sliver, true}};
    }
    if (pick < mix.slivers + mix.twins) {
        const Halves halves = halvesOf(random.chance(0.5) ? face : roundOpening(face, random), random);
        if (clean(halves.front, walls) && clean(halves.back, walls))
            return {{halves.front, halves.front, true}, {halves.back, halves.back, true}};
    }
    const double shape = random.unit();
    if (shape < 0.2 && clean(face, walls))
        return {{face, face, true}};
    if (shape < 0.4) {
        const Halves halves = halvesOf(face, random);
        const Polygon& part = random.chance(0.5) ? halves.front : halves.back;
        if (clean(part, walls))
            return {{part, part, true}};
    }
    const Polygon round = roundOpening(face, random);
    if (random.chance(mix.inexact)) {
        const Polygon other = shifted(round, face, random);
        if (fits(other, face))
            return {{round, other, false}};
    }
    return {{round, round, true}};
}

} // namespace limen::worlds
