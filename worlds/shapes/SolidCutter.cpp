#include "worlds/shapes/SolidCutter.h"

#include "worlds/shapes/Panel.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <queue>

namespace limen::worlds {

namespace {

/// Metres: the least distance of a corner from a plane that cuts its solid.
constexpr double kClearOfCut = 0.05;
constexpr int kAttempts = 40;
/// The smaller part of a cut has at least this share of the volume.
constexpr double kLeastShare = 0.22;

Solid boxSolid(const Vec3& min, const Vec3& max) {
    const Rect alongY{min.y, min.z, max.y, max.z};
    const Rect alongX{min.x, min.z, max.x, max.z};
    const Rect level{min.x, min.y, max.x, max.y};
    Solid box;
    box.sides = {{rectOnSide(Side::West, min.x, alongY), 0},  {rectOnSide(Side::East, max.x, alongY), 1},
                 {rectOnSide(Side::South, min.y, alongX), 2}, {rectOnSide(Side::North, max.y, alongX), 3},
                 {rectOnSide(Side::Floor, min.z, level), 4},  {rectOnSide(Side::Ceiling, max.z, level), 5}};
    return box;
}

double volumeOf(const Solid& solid) {
    double sum = 0.0;
    const Vec3 apex = solid.sides.front().points.front();
    for (const Solid::Side& side : solid.sides)
        sum += planeOf(side.points).signedDistance(apex) * areaOf(side.points) / 3.0;
    return sum;
}

Vec3 randomDirection(Random& random) {
    for (;;) {
        const Vec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        const double length = glm::length(v);
        if (length > 0.2 && length < 1.0)
            return v / length;
    }
}

Plane randomPlane(const Solid& solid, Random& random) {
    Vec3 n(0.0);
    if (random.chance(0.34))
        n[static_cast<int>(random.below(3))] = 1.0;
    else
        n = randomDirection(random);
    // Mostly across the longest extent: gives fewer splinters.
    const Vec3 through = middleOf(solid) + randomDirection(random) * 0.3;
    return {n, -glm::dot(n, through)};
}

bool staysClear(const Solid& solid, const Plane& plane) {
    return std::all_of(solid.sides.begin(), solid.sides.end(), [&](const Solid::Side& side) {
        return std::all_of(side.points.begin(), side.points.end(),
                           [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) > kClearOfCut; });
    });
}

/// The polygon around the points where a plane cuts a solid's sides, seen from the plane's front.
Polygon capOf(std::vector<Vec3> points, const Vec3& normal) {
    Vec3 middle(0.0);
    for (const Vec3& p : points)
        middle += p / static_cast<double>(points.size());
    const Vec3 u = glm::normalize(points.front() - middle);
    const Vec3 v = glm::cross(normal, u);
    std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
        const auto angle = [&](const Vec3& p) {
            return std::atan2(glm::dot(p - middle, v), glm::dot(p - middle, u));
        };
        return angle(a) < angle(b);
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

struct Parts {
    Solid front, back;
};

Parts cutSolid(const Solid& solid, const Plane& plane, std::int32_t number) {
    Parts parts;
    std::vector<Vec3> onPlane;
    for (const Solid::Side& side : solid.sides) {
        Halves halves = splitPolygon(side.points, plane);
        if (!halves.front.empty() && !halves.back.empty()) {
            for (const Vec3& p : halves.front)
                if (std::abs(plane.signedDistance(p)) < kOnCut)
                    onPlane.push_back(p);
        }
        if (!halves.front.empty())
            parts.front.sides.push_back({std::move(halves.front), side.cut});
        if (!halves.back.empty())
            parts.back.sides.push_back({std::move(halves.back), side.cut});
    }
    Polygon cap = capOf(std::move(onPlane), plane.n);
    parts.front.sides.push_back({cap, number});
    std::reverse(cap.begin(), cap.end());
    parts.back.sides.push_back({std::move(cap), number});
    return parts;
}

std::optional<Parts> tryCut(const Solid& solid, std::int32_t number, Random& random) {
    const double whole = volumeOf(solid);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const Plane plane = randomPlane(solid, random);
        if (!staysClear(solid, plane))
            continue;
        Parts parts = cutSolid(solid, plane, number);
        const double share = volumeOf(parts.front) / whole;
        if (share > kLeastShare && share < 1.0 - kLeastShare)
            return parts;
    }
    return std::nullopt;
}

} // namespace

Vec3 middleOf(const Solid& solid) {
    Vec3 sum(0.0);
    double weight = 0.0;
    for (const Solid::Side& side : solid.sides) {
        const double area = areaOf(side.points);
        sum += centroidOf(side.points) * area;
        weight += area;
    }
    return sum / weight;
}

std::vector<Solid> cutBox(const Vec3& min, const Vec3& max, std::uint32_t count, Random& random) {
    std::vector<Solid> solids{boxSolid(min, max)};
    // The largest is cut next. One that cannot be cut is tried again when no other is left.
    std::priority_queue<std::pair<double, std::uint32_t>> bySize;
    bySize.emplace(volumeOf(solids[0]), 0);
    std::int32_t number = 6;
    while (solids.size() < count) {
        const auto [size, index] = bySize.top();
        bySize.pop();
        std::optional<Parts> parts = tryCut(solids[index], number, random);
        if (!parts) {
            bySize.emplace(size * 0.9, index);
            continue;
        }
        ++number;
        solids[index] = std::move(parts->front);
        bySize.emplace(volumeOf(solids[index]), index);
        bySize.emplace(volumeOf(parts->back), static_cast<std::uint32_t>(solids.size()));
        solids.push_back(std::move(parts->back));
    }
    return solids;
}

std::vector<SharedFace> sharedFaces(const std::vector<Solid>& solids, double leastRadius) {
    struct Ref {
        std::uint32_t solid, side;
        Plane plane;
    };
    std::map<std::int32_t, std::vector<Ref>> byCut;
    for (std::uint32_t s = 0; s < solids.size(); ++s) {
        for (std::uint32_t k = 0; k < solids[s].sides.size(); ++k) {
            const Solid::Side& side = solids[s].sides[k];
            if (side.cut >= 6)
                byCut[side.cut].push_back({s, k, planeOf(side.points)});
        }
    }
    std::vector<SharedFace> out;
    for (const auto& [cut, refs] : byCut) {
        for (const Ref& a : refs) {
            if (glm::dot(a.plane.n, refs.front().plane.n) < 0.0)
                continue;
            for (const Ref& b : refs) {
                if (glm::dot(a.plane.n, b.plane.n) > 0.0)
                    continue;
                const Polygon& mine = solids[a.solid].sides[a.side].points;
                Polygon theirs = solids[b.solid].sides[b.side].points;
                std::reverse(theirs.begin(), theirs.end());
                Polygon both = commonPart(mine, theirs, a.plane.n);
                if (!both.empty() && edgeDistance(both, centroidOf(both)) >= leastRadius)
                    out.push_back({a.solid, b.solid, a.side, b.side, std::move(both)});
            }
        }
    }
    return out;
}

} // namespace limen::worlds
