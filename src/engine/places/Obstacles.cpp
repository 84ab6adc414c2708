#include "engine/places/Obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limen::engine {
namespace {

constexpr double kLeastUp = 0.66; // upward part of the normal of a surface to stand on, as of bodies

/// The share of the way to a triangle's plane within its edges; 1 if the way misses it. Ref: Moeller and
/// Trumbore 1997.
double shareTo(const Triangle& t, const Vec3& from, const Vec3& way) {
    const Vec3 u = t.b - t.a, v = t.c - t.a, p = glm::cross(way, v);
    const double determinant = glm::dot(u, p);
    if (std::abs(determinant) < 1e-12)
        return 1.0;
    const Vec3 s = from - t.a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / determinant, y = glm::dot(way, q) / determinant;
    const double share = glm::dot(v, q) / determinant;
    return x >= 0.0 && y >= 0.0 && x + y <= 1.0 && share >= 0.0 && share < 1.0 ? share : 1.0;
}

/// True if the way is on one side of the triangle along an axis. Cheaper than shareTo.
bool isBeside(const Triangle& t, const Vec3& low, const Vec3& high) {
    for (int axis = 0; axis < 3; ++axis)
        if ((t.a[axis] < low[axis] && t.b[axis] < low[axis] && t.c[axis] < low[axis]) ||
            (t.a[axis] > high[axis] && t.b[axis] > high[axis] && t.c[axis] > high[axis]))
            return true;
    return false;
}

bool mayMeet(const Aabb& box, const Vec3& from, const Vec3& to) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::max(from[axis], to[axis]) < box.min[axis] || std::min(from[axis], to[axis]) > box.max[axis])
            return false;
    return true;
}

} // namespace

Vec3 Triangle::normal() const {
    const Vec3 across = glm::cross(b - a, c - a);
    const double length = glm::length(across);
    return length > 1e-9 ? across / length : Vec3(0.0);
}

void addFan(std::span<const Vec3> polygon, std::vector<Triangle>& out) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
        out.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

void Obstacles::add(std::vector<Triangle> group) {
    if (group.empty())
        return;
    Aabb bounds;
    for (const Triangle& t : group)
        for (const Vec3& corner : {t.a, t.b, t.c})
            bounds.include(corner);
    groups_.push_back({bounds, std::move(group)});
}

double Obstacles::freeShare(const Vec3& from, const Vec3& to) const {
    double share = 1.0;
    const Vec3 low = glm::min(from, to), high = glm::max(from, to);
    for (const Group& group : groups_)
        if (mayMeet(group.bounds, from, to))
            for (const Triangle& triangle : group.triangles)
                if (!isBeside(triangle, low, high))
                    share = std::min(share, shareTo(triangle, from, to - from));
    return share;
}

bool Obstacles::crowds(const Vec3& point, double metres, int directions) const {
    for (int i = 0; i < directions; ++i) {
        const double angle = i * 2.0 * std::numbers::pi / directions;
        if (blocks(point, point + metres * Vec3(std::cos(angle), std::sin(angle), 0.0)))
            return true;
    }
    return false;
}

double Obstacles::floorBelow(const Vec3& point, double depth) const {
    double highest = std::numeric_limits<double>::quiet_NaN();
    const Vec3 way(0.0, 0.0, -depth);
    for (const Group& group : groups_) {
        if (!mayMeet(group.bounds, point, point + way))
            continue;
        for (const Triangle& triangle : group.triangles) {
            const double share = shareTo(triangle, point, way);
            if (share < 1.0 && triangle.normal().z > kLeastUp)
                highest = std::fmax(highest, point.z - depth * share);
        }
    }
    return highest;
}

} // namespace limen::engine
