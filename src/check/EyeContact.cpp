#include "check/EyeContact.h"

#include "geometry/Segment.h"
#include "geometry/Tolerances.h"

#include <algorithm>

namespace limen::check {

namespace {

bool touchesEdge(std::span<const Vec3> corners, const Vec3& point) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (distanceToSegment(point, corners[i], corners[(i + 1) % corners.size()]).distance <=
            kEyeInPlaneTolerance)
            return true;
    return false;
}

} // namespace

EyeContact::EyeContact(const world::World& world, const PolygonTable& polygons, world::SpaceIndex root,
                       const Vec3& eye) {
    std::vector<Triangle> touched;
    polygons.trianglesAround(root, eye, kEyeInPlaneTolerance, touched);
    for (const Triangle& triangle : touched)
        inward_.push_back(planeOf(triangle.corners).n);
    polygons.wallsAround(root, eye, kInPlaneTolerance, touched);
    for (const Triangle& triangle : touched)
        if (const Plane plane = planeOf(triangle.corners); plane.signedDistance(eye) < 0.0)
            inward_.push_back(plane.n);
    const world::Space& space = world.spaces[root];
    for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
        const world::Portal& portal = world.portals[p];
        if (touchesEdge(cornersOf(world, portal), eye))
            inward_.push_back(portal.plane.n);
    }
}

bool EyeContact::leadsIntoTheRoot(const Vec3& direction) const {
    return std::all_of(inward_.begin(), inward_.end(),
                       [&](const Vec3& n) { return glm::dot(n, direction) > 0.0; });
}

} // namespace limen::check
