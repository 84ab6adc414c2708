#include "reference/Openings.h"

#include "geometry/ConvexPolygon.h"
#include "reference/Pyramid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limen::reference {
namespace {

/// Up to this many portals of a space are tested one by one.
constexpr std::uint32_t kFewPortals = 6;
/// The most portals in a hierarchy's leaf.
constexpr std::uint32_t kPortalsOfLeaf = 4;

/// True if the ray meets the convex polygon that faces it, edges included.
bool meetsConvex(const RayFrame& ray, std::span<const Vec3> polygon) {
    Sheared last = ray(polygon.back());
    for (const Vec3& p : polygon) {
        const Sheared corner = ray(p);
        if (edgeSide(last, corner) < 0.0)
            return false;
        last = corner;
    }
    return true;
}

/// The same for a polygon that is only nearly convex: it winds around the ray, or the ray meets an edge. Ref:
/// Hormann, Agathos, "The Point in Polygon Problem for Arbitrary Polygons" (2001).
bool meetsOutline(const RayFrame& ray, std::span<const Vec3> polygon) {
    int winding = 0;
    Sheared last = ray(polygon.back());
    for (const Vec3& p : polygon) {
        const Sheared corner = ray(p);
        const double side = edgeSide(last, corner);
        if (side == 0.0 && last.x * corner.x + last.y * corner.y <= 0.0)
            return true;
        if ((last.y <= 0.0) != (corner.y <= 0.0)) {
            const bool up = last.y <= 0.0;
            winding += up ? (side < 0.0 ? 1 : 0) : (side > 0.0 ? -1 : 0);
        }
        last = corner;
    }
    return winding != 0;
}

/// Sets the stretch in which the ray is within kInPlaneTolerance of a plane that it crosses at `t`; `speed`
/// in metres per unit of the parameter.
void setBand(Exit& exit, double t, double speed) {
    const double half = kInPlaneTolerance / std::abs(speed);
    exit.before = t - half;
    exit.beyond = t + half;
}

bool contains(std::span<const world::PortalIndex> portals, world::PortalIndex portal) {
    return std::find(portals.begin(), portals.end(), portal) != portals.end();
}

} // namespace

void Openings::addOpening(const world::Portal& portal, const Vec3& origin) {
    Opening opening{portal.plane.relativeTo(origin), static_cast<std::uint32_t>(points_.size()),
                    portal.cornerCount};
    for (const Vec3& p : world::cornersOf(world_, portal))
        points_.push_back(p - origin);
    if (portal.vertexCount > portal.cornerCount) {
        opening.firstOutline = static_cast<std::uint32_t>(points_.size());
        opening.outlineCount = portal.vertexCount;
        for (const Vec3& p : world::polygonOf(world_, portal))
            points_.push_back(p - origin);
    }
    const std::span<const Vec3> points = std::span(points_).subspan(opening.firstCorner);
    const double off = std::transform_reduce(
        points.begin(), points.end(), 0.0, [](double a, double b) { return std::max(a, b); },
        [&](const Vec3& p) { return std::abs(opening.plane.signedDistance(p)); });
    opening.before = std::min(kInPlaneTolerance, kEyeInPlaneTolerance + off);
    openings_.push_back(opening);
}

Openings::Openings(const world::World& world, const Vec3& origin) : world_(world) {
    for (const world::Portal& portal : world.portals)
        addOpening(portal, origin);
    std::vector<Box> boxes;
    std::vector<std::uint32_t> order;
    for (const world::Space& space : world.spaces) {
        SpaceOpenings& here = spaces_.emplace_back();
        here.first = static_cast<std::uint32_t>(order_.size());
        boxes.clear();
        for (world::PortalIndex i = space.firstPortal; i < space.firstPortal + space.portalCount; ++i) {
            if (openings_[i].cornerCount < 3 || world.portals[i].walled)
                continue; // shut by the loader, or a surface
            Extent extent;
            const Opening& opening = openings_[i];
            for (const Vec3& p : cornersOf(opening))
                extent.include(p);
            for (const Vec3& p : std::span(points_).subspan(opening.firstOutline, opening.outlineCount))
                extent.include(p);
            Box box = extent.box();
            box.grow(2.0 * kInPlaneTolerance); // an eye in the opening's plane is in the box
            boxes.push_back(box);
            order_.push_back(i);
        }
        here.count = static_cast<std::uint32_t>(order_.size()) - here.first;
        if (here.count <= kFewPortals)
            continue;
        here.tree.build(boxes, kPortalsOfLeaf, order);
        const std::vector<std::uint32_t> portals(order_.begin() + here.first, order_.end());
        for (std::uint32_t i = 0; i < here.count; ++i)
            order_[here.first + i] = portals[order[i]];
    }
}

template <class Offer>
void Openings::offerAll(const BoxRay& boxRay, const Leaving& from, const double& farthest,
                        Offer&& offer) const {
    const SpaceOpenings& here = spaces_[from.space];
    const auto offerRun = [&](std::uint32_t first, std::uint32_t count) {
        for (const world::PortalIndex portal : std::span(order_).subspan(here.first + first, count))
            offer(portal);
    };
    if (here.tree.empty())
        offerRun(0, here.count);
    else
        here.tree.walk(boxRay, 0.0, farthest, offerRun);
}

void Openings::gather(world::SpaceIndex space, const Pyramid& pyramid,
                      std::vector<world::PortalIndex>& portals) const {
    const SpaceOpenings& here = spaces_[space];
    const auto gatherRun = [&](std::uint32_t first, std::uint32_t count) {
        for (const world::PortalIndex portal : std::span(order_).subspan(here.first + first, count)) {
            // An eye in the opening's plane may be the tolerance off it.
            if (pyramid.mayMeet(cornersOf(openings_[portal]), 2.0 * kInPlaneTolerance) ||
                pyramid.mayMeet(outlineOf(openings_[portal]), 2.0 * kInPlaneTolerance))
                portals.push_back(portal);
        }
    };
    const auto open = [&](std::uint32_t node, const auto& self) -> void {
        here.tree.open(
            node, [&](const auto& sides, auto& least) { return pyramid.meetsBoxes(sides, least); },
            [&](std::uint32_t child, std::uint32_t count, float) {
                count > 0 ? gatherRun(child, count) : self(child, self);
            });
    };
    here.tree.empty() ? gatherRun(0, here.count) : open(0, open);
}

double Openings::speedOut(world::PortalIndex portal, const RayFrame& ray, const Leaving& from) const {
    if (from.cameBy != world::kNone && world_.portals[from.cameBy].reciprocal == portal)
        return 0.0;
    return std::max(-glm::dot(openings_[portal].plane.n, ray.direction), 0.0);
}

bool Openings::isOpenAt(const Opening& opening, const RayFrame& ray) const {
    // The walls end at the outline, to the bit; the corners alone are the polygon of the data. The ray may
    // pass either. A wall that reaches into the corners' polygon is in its plane and met from both sides.
    return meetsConvex(ray, cornersOf(opening)) ||
           (opening.outlineCount > 0 && meetsOutline(ray, outlineOf(opening)));
}

bool Openings::holdsEye(const Opening& opening, const Vec3& eye, double way) const {
    const double side = way * opening.plane.signedDistance(eye);
    return side >= -kInPlaneTolerance && side <= opening.before &&
           containsProjection(cornersOf(opening), opening.plane.n, eye, 0.0);
}

void Openings::offer(world::PortalIndex i, const RayFrame& ray, const Leaving& from, Exit& exit) const {
    const double speed = speedOut(i, ray, from);
    if (!(speed > 0.0))
        return;
    const Opening& opening = openings_[i];
    const double side = opening.plane.signedDistance(ray.eye);
    const bool shut = !from.shut.empty() && from.shut[i] != 0;
    // No ray leaves by a shut portal, so it cannot hold the eye either.
    const bool inPlane = from.after <= 0.0 && !shut && holdsEye(opening, ray.eye, 1.0) &&
                         !contains(from.notAgain, i) && (side >= -opening.before || isNearest(i, ray.eye));
    const double at = inPlane ? 0.0 : side / speed;
    if (!inPlane && (!(side > 0.0 && at > from.after) || (shut && at < from.nearPlane)))
        return;
    if (at > exit.t || (at == exit.t && i > exit.portal) || (!inPlane && !isOpenAt(opening, ray)))
        return;
    exit.portal = i;
    exit.t = at;
    setBand(exit, side / speed, speed);
}

Exit Openings::nearest(const RayFrame& ray, const BoxRay& boxRay, const Leaving& from) const {
    Exit exit;
    offerAll(boxRay, from, exit.t, [&](world::PortalIndex portal) { offer(portal, ray, from, exit); });
    return exit;
}

Exit Openings::nearest(std::span<const world::PortalIndex> portals, const RayFrame& ray,
                       const Leaving& from) const {
    Exit exit;
    for (const world::PortalIndex portal : portals)
        offer(portal, ray, from, exit);
    return exit;
}

Exit Openings::nearestGrown(const RayFrame& ray, const BoxRay& boxRay, const Leaving& from,
                            const GapTest& isGap) const {
    Exit exit;
    offerAll(boxRay, from, exit.t, [&](world::PortalIndex i) {
        const double speed = speedOut(i, ray, from);
        if (!(speed > 0.0) || contains(from.notAgain, i))
            return;
        const Opening& opening = openings_[i];
        Exit other{i, opening.plane.signedDistance(ray.eye) / speed, 0.0, 0.0};
        setBand(other, other.t, speed);
        const bool shut = !from.shut.empty() && from.shut[i] != 0;
        // Two openings that share an edge are crossed at one parameter, up to rounding: hence `beyond`.
        if (other.t < 0.0 || other.beyond < from.after || (shut && other.t < from.nearPlane) ||
            other.t > exit.t || (other.t == exit.t && i > exit.portal))
            return;
        const Vec3 point = ray.eye + ray.direction * other.t;
        if (containsProjection(cornersOf(opening), opening.plane.n, point, kGapTolerance) &&
            isGap(point, cornersOf(opening)))
            exit = other;
    });
    return exit;
}

bool Openings::isWithin(const Opening& opening, const Vec3& eye) const {
    return containsProjection(cornersOf(opening), opening.plane.n, eye, 0.0);
}

/// Whether an eye is behind the portal's plane, farther than an eye in it and not farther than the tolerance.
bool Openings::isPassed(world::PortalIndex portal, const Vec3& eye) const {
    const Opening& opening = openings_[portal];
    const double past = -opening.plane.signedDistance(eye);
    if (past <= opening.before || past > kInPlaneTolerance || !isWithin(opening, eye))
        return false;
    const world::PortalIndex back = world_.portals[portal].reciprocal;
    return world_.portals[portal].exact || back == world::kNone ||
           (openings_[back].cornerCount >= 3 && openings_[back].plane.signedDistance(eye) > 0.0 &&
            isWithin(openings_[back], eye));
}

/// Whether the eye is at no other opening from the space into the same one that is nearer.
bool Openings::isNearest(world::PortalIndex portal, const Vec3& eye) const {
    const world::Portal& of = world_.portals[portal];
    const SpaceOpenings& here = spaces_[of.space];
    const double distance = std::abs(openings_[portal].plane.signedDistance(eye));
    return std::none_of(
        order_.begin() + here.first, order_.begin() + here.first + here.count, [&](world::PortalIndex i) {
            return i != portal && world_.portals[i].destination == of.destination &&
                   std::abs(openings_[i].plane.signedDistance(eye)) < distance && isWithin(openings_[i], eye);
        });
}

world::SpaceIndex Openings::spaceOfEye(world::SpaceIndex root, const Vec3& eye) const {
    constexpr int kMostPassed = 4; // openings that meet in a corner
    world::PortalIndex cameBy = world::kNone;
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const SpaceOpenings& here = spaces_[root];
        const auto first = order_.begin() + here.first, end = first + here.count;
        world::PortalIndex next = world::kNone;
        std::for_each(first, end, [&](world::PortalIndex i) {
            const bool isBack = cameBy != world::kNone && world_.portals[cameBy].reciprocal == i;
            if (i < next && !isBack && world_.portals[i].destination != world::kNone && isPassed(i, eye) &&
                isNearest(i, eye))
                next = i;
        });
        if (next == world::kNone)
            break;
        cameBy = next;
        root = world_.portals[next].destination;
    }
    return root;
}

bool Openings::passesPair(world::PortalIndex portal, const RayFrame& ray, double after) const {
    const world::PortalIndex back = world_.portals[portal].reciprocal;
    if (world_.portals[portal].exact || back == world::kNone)
        return true;
    const Opening& other = openings_[back];
    if (other.cornerCount < 3)
        return false;
    if (after <= 0.0 && holdsEye(other, ray.eye, -1.0))
        return true;
    const double speed = glm::dot(other.plane.n, ray.direction);
    const double t = -other.plane.signedDistance(ray.eye) / speed;
    return speed != 0.0 &&
           containsProjection(cornersOf(other), other.plane.n, ray.eye + ray.direction * t, 0.0);
}

} // namespace limen::reference
