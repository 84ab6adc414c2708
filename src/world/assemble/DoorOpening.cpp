#include "world/assemble/DoorOpening.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "world/OpeningParts.h"

#include <algorithm>
#include <limits>

namespace limen::world {
namespace {

constexpr double kBefore = 0.5;            // metres from the middle of a door to its opening
constexpr double kAligned = 0.93969262078; // cosine of 20 degrees
constexpr double kOfBox = 0.5, kOfPortal = 0.4;

/// Two perpendicular directions in a portal's plane.
struct PlaneAxes {
    Vec3 across{0.0}, up{0.0};
};
PlaneAxes axesOf(const Vec3& normal) {
    const Vec3 towards = std::abs(normal.z) < 0.7 ? Vec3(0.0, 0.0, 1.0) : Vec3(0.0, 1.0, 0.0);
    const Vec3 across = glm::normalize(glm::cross(towards, normal));
    return {across, glm::cross(normal, across)};
}

struct PlaneRect {
    Vec2 min{std::numeric_limits<double>::infinity()}, max{-std::numeric_limits<double>::infinity()};
    void add(const Vec2& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    [[nodiscard]] double area() const {
        const Vec2 size = glm::max(max - min, Vec2(0.0));
        return size.x * size.y;
    }
};

PlaneRect common(const PlaneRect& a, const PlaneRect& b) {
    PlaneRect both;
    both.min = glm::max(a.min, b.min);
    both.max = glm::min(a.max, b.max);
    return both;
}

Vec2 inPlane(const PlaneAxes& axes, const Vec3& p) {
    return {glm::dot(axes.across, p), glm::dot(axes.up, p)};
}

/// The index of the box's thinnest axis, which points through the door.
std::size_t thinAxis(const DoorBox& box) {
    const Vec3& half = box.half;
    return half.x <= half.y && half.x <= half.z ? 0 : half.y <= half.z ? 1 : 2;
}

PlaneRect rectOf(const DoorBox& box, const PlaneAxes& axes) {
    PlaneRect rect;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p = box.centre;
        for (int axis = 0; axis < 3; ++axis)
            p += box.axes[static_cast<std::size_t>(axis)] * box.half[axis] *
                 ((corner >> axis & 1) != 0 ? 1.0 : -1.0);
        rect.add(inPlane(axes, p));
    }
    return rect;
}

/// The distance of the box's middle from the plane; infinite if the door does not fit the portal.
double fitOf(const World& world, const DoorBox& box, const Portal& portal) {
    constexpr double kNo = std::numeric_limits<double>::infinity();
    const double distance = std::abs(portal.plane.signedDistance(box.centre));
    if (!(distance <= kBefore) || std::abs(glm::dot(portal.plane.n, box.axes[thinAxis(box)])) < kAligned)
        return kNo;
    const PlaneAxes axes = axesOf(portal.plane.n);
    PlaneRect opening;
    for (const Vec3& corner : cornersOf(world, portal))
        opening.add(inPlane(axes, corner));
    const PlaneRect door = rectOf(box, axes);
    const double shared = common(opening, door).area();
    const bool fits = shared >= kOfBox * door.area() && shared >= kOfPortal * opening.area() && shared > 0.0;
    return fits ? distance : kNo;
}

bool containsPoint(const std::array<Vec2, 3>& t, const Vec2& p) {
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double x = side(t[0], t[1], p), y = side(t[1], t[2], p), z = side(t[2], t[0], p);
    return (x >= 0.0 && y >= 0.0 && z >= 0.0) || (x <= 0.0 && y <= 0.0 && z <= 0.0);
}

} // namespace

std::optional<DoorOpening> findOpening(const World& world, const DoorBox& box) {
    LIMEN_ASSERT(box.half.x >= 0.0 && box.half.y >= 0.0 && box.half.z >= 0.0, "the box is not empty");
    const double reach = glm::length(box.half) + kBefore;
    double best = std::numeric_limits<double>::infinity();
    PortalIndex found = kNone;
    for (PortalIndex p = 0; p < world.portals.size(); ++p) {
        // The outside's portals are the other sides of cells' portals.
        if (world.portals[p].part > 0 ||
            (world.portals[p].space == kOutside && world.portals[p].reciprocal != kNone))
            continue;
        const Portal& portal = openingOf(world, p);
        if (portal.cornerCount < 3)
            continue;
        if (glm::length(cornersOf(world, portal).front() - box.centre) > 2.0 * reach + kBefore)
            continue;
        if (const double fit = fitOf(world, box, portal); fit < best) {
            best = fit;
            found = p;
        }
    }
    if (found == kNone)
        return std::nullopt;
    const Plane& plane = openingOf(world, found).plane;
    return DoorOpening{found, plane.n * -plane.signedDistance(box.centre)};
}

double coveredShare(const World& world, const Portal& portal, std::span<const Vec3> corners) {
    LIMEN_ASSERT(corners.size() % 3 == 0, "three corners for each triangle");
    constexpr int kSteps = 14;
    const PlaneAxes axes = axesOf(portal.plane.n);
    PlaneRect bounds;
    std::vector<Vec3> outline;
    for (const Vec3& corner : cornersOf(world, portal)) {
        outline.push_back(corner);
        bounds.add(inPlane(axes, corner));
    }
    const Vec3 onPlane = portal.plane.n * -portal.plane.d;
    int inside = 0, covered = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const Vec2 share((i % kSteps + 0.5) / kSteps, (i / kSteps + 0.5) / kSteps);
        const Vec2 at = bounds.min + (bounds.max - bounds.min) * share;
        if (!containsProjection(outline, portal.plane.n, onPlane + axes.across * at.x + axes.up * at.y, 0.0))
            continue;
        ++inside;
        for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
            if (containsPoint(
                    {inPlane(axes, corners[t]), inPlane(axes, corners[t + 1]), inPlane(axes, corners[t + 2])},
                    at)) {
                ++covered;
                break;
            }
        }
    }
    return inside > 0 ? static_cast<double>(covered) / inside : 0.0;
}

} // namespace limen::world
