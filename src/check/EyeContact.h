#pragma once

#include "check/PolygonTable.h"

namespace limen::check {

/// The surfaces and edges of the root space that an eye touches. docs/ray-rule.md: an eye exactly on an edge
/// of an opening or in a wall's plane is judged only for rays into that space.
///
/// An eye touches a surface of its space, or an edge of one of its openings, within kEyeInPlaneTolerance. Being
/// in the plane of a distant wall is no contact. An eye behind a wall of its cell, by up to kInPlaneTolerance,
/// touches it, too: it is out of its cell, and no space has rays away from the wall. A wall that is not flat has
/// such places in its plane. A ray leads into the space if it leaves every touched plane on the side of the
/// space: the front of a surface, the inner side of an opening. Without contact every ray is judged, also inside
/// an opening.
class EyeContact {
public:
    EyeContact(const world::World& world, const PolygonTable& polygons, world::SpaceIndex root,
               const Vec3& eye);
    [[nodiscard]] bool leadsIntoTheRoot(const Vec3& direction) const;
    [[nodiscard]] bool touchesNothing() const { return inward_.empty(); }

private:
    std::vector<Vec3> inward_; ///< normals of the touched planes, towards the root space
};

} // namespace limen::check
