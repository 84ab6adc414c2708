#include "worlds/records/Sight.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>

namespace limen::worlds {

namespace {

constexpr int kSamples = 9; ///< per direction and opening
constexpr double kNear = 1e-6;

/// Points spread over a convex polygon: between its first corner and its far edges, just inside the border.
std::vector<Vec3> samplePoints(const std::vector<Vec3>& polygon) {
    std::vector<Vec3> out;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        for (int a = 0; a < kSamples; ++a) {
            for (int b = 0; b < kSamples; ++b) {
                const double s = 0.002 + 0.996 * a / (kSamples - 1);
                const double t = 0.002 + 0.996 * b / (kSamples - 1);
                const Vec3 edge = polygon[i] + (polygon[i + 1] - polygon[i]) * t;
                out.push_back(polygon[0] + (edge - polygon[0]) * s);
            }
        }
    }
    return out;
}

/// The opening through which the ray leaves the cell, or null if a wall stops it.
const SightMap::Portal* exitOf(const SightMap::Cell& cell, const Vec3& from, const Vec3& direction) {
    double nearest = 1e300;
    for (const Plane& plane : cell.planes) {
        const double approach = glm::dot(plane.n, direction);
        if (approach < -kNear)
            nearest = std::min(nearest, -plane.signedDistance(from) / approach);
    }
    const Vec3 at = from + direction * nearest;
    for (const SightMap::Portal& portal : cell.portals) {
        const Plane plane = planeOf(portal.points);
        const bool leaving = glm::dot(plane.n, direction) < -kNear;
        if (leaving && std::abs(plane.signedDistance(at)) < 1e-4 &&
            containsProjection(portal.points, plane.n, at, 1e-4))
            return &portal;
    }
    return nullptr;
}

bool reachesOutside(const SightMap& map, std::size_t cell, const Vec3& from, const Vec3& direction) {
    for (std::size_t step = 0; step <= map.cells.size(); ++step) {
        const SightMap::Portal* portal = exitOf(map.cells[cell], from, direction);
        if (portal == nullptr)
            return false;
        if (portal->to == SightMap::kOutside)
            return true;
        cell = portal->to;
    }
    return false;
}

} // namespace

bool seesOutside(const SightMap& map, std::size_t cell) {
    for (const SightMap::Portal& first : map.cells[cell].portals)
        if (first.to == SightMap::kOutside)
            return true;
    std::vector<Vec3> targets;
    for (const SightMap::Cell& other : map.cells) {
        for (const SightMap::Portal& portal : other.portals) {
            if (portal.to == SightMap::kOutside) {
                const std::vector<Vec3> points = samplePoints(portal.points);
                targets.insert(targets.end(), points.begin(), points.end());
            }
        }
    }
    for (const SightMap::Portal& first : map.cells[cell].portals) {
        const Plane plane = planeOf(first.points);
        for (const Vec3& from : samplePoints(first.points)) {
            for (const Vec3& to : targets) {
                const Vec3 direction = glm::normalize(to - from);
                if (glm::dot(plane.n, direction) < -kNear && reachesOutside(map, first.to, from, direction))
                    return true;
            }
        }
    }
    return false;
}

std::vector<bool> cellsThatSeeOutside(const SightMap& map) {
    std::vector<bool> sees(map.cells.size(), false);
    std::vector<bool> queued(map.cells.size(), false);
    std::vector<std::size_t> next;
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        const std::vector<SightMap::Portal>& portals = map.cells[c].portals;
        if (std::any_of(portals.begin(), portals.end(),
                        [](const SightMap::Portal& p) { return p.to == SightMap::kOutside; })) {
            queued[c] = true;
            next.push_back(c);
        }
    }
    while (!next.empty()) {
        const std::size_t c = next.back();
        next.pop_back();
        sees[c] = seesOutside(map, c);
        for (const SightMap::Portal& portal : map.cells[c].portals) {
            if (sees[c] && portal.to != SightMap::kOutside && !queued[portal.to]) {
                queued[portal.to] = true;
                next.push_back(portal.to);
            }
        }
    }
    return sees;
}

} // namespace limen::worlds
