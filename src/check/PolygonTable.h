#pragma once

#include "geometry/Vec.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <array>
#include <vector>

namespace limen::check {

/// A triangle of a drawn polygon in global coordinates, counter-clockwise from the front.
struct Triangle {
    std::array<Vec3, 3> corners{Vec3(0.0), Vec3(0.0), Vec3(0.0)};
};

/// Finds the triangles behind ids and around points. The world and the moment must outlive it; the moment may change.
class PolygonTable {
public:
    PolygonTable(const world::World& world, const world::DynamicState& dynamics);

    /// The triangles that show as `id`; none for void, sky and ids that nothing has. `out` is overwritten.
    void trianglesOf(std::uint32_t id, std::vector<Triangle>& out) const;
    /// The opaque and cut-out triangles that members of `space` have within `reach` metres of a point. `out` is
    /// overwritten.
    void trianglesAround(world::SpaceIndex space, const Vec3& point, double reach,
                         std::vector<Triangle>& out) const;

    /// The ids of all polygons of instances whose ball, and a pixel's width around it, a ray passes. `direction` need not be
    /// of unit length. `out` is overwritten.
    void polygonsAlong(const Vec3& eye, const Vec3& direction, std::vector<std::uint32_t>& out) const;

private:
    [[nodiscard]] const world::Instance* instanceOf(std::uint32_t id) const;
    template <class Visit>
    void forTriangles(const world::Instance& instance, bool blended, Visit visit) const;
    void addTrianglesAround(const world::Instance& instance, const Vec3& point, double reach,
                            std::vector<Triangle>& out) const;

    const world::World& world_;
    const world::DynamicState& dynamics_;
    std::vector<const world::Instance*> byId_; ///< static ones with polygons, ascending by idBase
};

} // namespace limen::check
