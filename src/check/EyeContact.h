#pragma once

#include "check/PolygonTable.h"

namespace limen::check {

/// What an eye touches of the space it is said to be in. docs/ray-rule.md: an eye exactly on an edge of an opening or in
/// a wall's plane is judged only for rays into that space.
///
/// How that is read here. The eye touches a surface of its space, or an edge of one of its openings, that passes
/// within 0.2 mm of it; lying in the plane of a wall that is elsewhere is no contact. A ray leads into the space if it
/// leaves every plane that is touched on the side of the space: the front of a surface, the inner side of an opening.
/// Nothing touched, and every ray is judged; inside an opening, clear of its edges, too.
class EyeContact {
public:
    static constexpr double kReach = 0.0002; ///< metres

    EyeContact(const world::World& world, const PolygonTable& polygons, world::SpaceIndex root,
               const Vec3& eye);
    [[nodiscard]] bool leadsIntoTheRoot(const Vec3& direction) const;
    [[nodiscard]] bool touchesNothing() const { return inward_.empty(); }

private:
    std::vector<Vec3> inward_; ///< normals of what is touched, towards the root
};

} // namespace limen::check
