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

/// Finds triangles by id and around points. World and dynamic state must outlive it; the dynamic state may
/// change.
class PolygonTable {
public:
    PolygonTable(const world::World& world, const world::DynamicState& dynamics);

    /// The triangles with an id; none for void, sky and unused ids. Overwrites `out`.
    void trianglesOf(std::uint32_t id, std::vector<Triangle>& out) const;
    /// The opaque and cut-out triangles of members of `space` within `reach` metres of a point. Overwrites
    /// `out`.
    void trianglesAround(world::SpaceIndex space, const Vec3& point, double reach,
                         std::vector<Triangle>& out) const;

    /// The opaque and cut-out triangles of a cell's own walls within `reach` metres of a point. Overwrites `out`.
    void wallsAround(world::SpaceIndex space, const Vec3& point, double reach,
                     std::vector<Triangle>& out) const;

    /// The ids of all polygons of instances whose bounding sphere, grown by a pixel, a ray passes.
    /// `direction` may have any length. Overwrites `out`.
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
