#pragma once

#include "geometry/Bounds.h"
#include "geometry/Vec.h"

#include <span>
#include <vector>

namespace limen::engine {

/// A triangle in global metres, counter-clockwise seen from its front.
struct Triangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};
    [[nodiscard]] Vec3 normal() const; ///< unit; zero without area
};
/// The fan of a convex polygon.
void addFan(std::span<const Vec3> polygon, std::vector<Triangle>& out);

/// Triangles that block straight ways, in groups with bounds. Both sides of a triangle block.
class Obstacles {
public:
    /// Ignores an empty group.
    void add(std::vector<Triangle> group);
    /// The share of the way from `from` to `to` up to the first triangle; 1 if the way is free.
    [[nodiscard]] double freeShare(const Vec3& from, const Vec3& to) const;
    [[nodiscard]] bool blocks(const Vec3& from, const Vec3& to) const { return freeShare(from, to) < 1.0; }
    /// True if triangles are within `metres` of `point` in one of `directions` horizontal directions.
    [[nodiscard]] bool crowds(const Vec3& point, double metres, int directions = 8) const;
    /// The highest surface under `point` that faces up, at most `depth` metres below; NaN if there is none.
    [[nodiscard]] double floorBelow(const Vec3& point, double depth) const;

    struct Group {
        Aabb bounds;
        std::vector<Triangle> triangles;
    };
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }

private:
    std::vector<Group> groups_;
};

} // namespace limen::engine
