#include "motion/Locate.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>
#include <array>
#include <optional>

namespace limen::motion {
namespace {

/// A point this far in front of a plane's back side is still in front; metres (docs/formats/cells.md#point-in-cell).
constexpr double kPlaneSlack = 0.0002;
/// How far outside an opening's edges a segment may pass and still go through it; metres (docs/ray-rule.md#tolerances).
constexpr double kOpeningSlack = 0.0002;

/// Where a segment leaves a space.
struct Crossing {
    double t = 2.0; ///< along the segment
    world::PortalIndex portal = world::kNone;
};

/// The parameter at which from-to passes from the space's side of a portal to the other through the opening.
/// A segment that starts in the plane and leaves, or that starts within the slack behind it, passes at once.
std::optional<double> crossingOf(const world::World& world, const world::Portal& portal, const Vec3& from,
                                 const Vec3& to) {
    const double before = portal.plane.signedDistance(from), after = portal.plane.signedDistance(to);
    if (portal.plane.n == Vec3(0.0) || before < -kPlaneSlack || after >= 0.0 || after >= before)
        return std::nullopt;
    const double t = std::clamp(before / (before - after), 0.0, 1.0);
    const Vec3 at = from + (to - from) * t;
    if (!containsProjection(world::cornersOf(world, portal), portal.plane.n, at, kOpeningSlack))
        return std::nullopt;
    return t;
}

} // namespace

bool cellContains(const world::World& world, world::SpaceIndex index, const Vec3& position) {
    if (index >= world.spaces.size() || !isFinite(position))
        return false;
    const world::Space& space = world.spaces[index];
    // Behind these the cell may go on: nodes that the point lies in the plane of, as good as in front of them. A point is in
    // more such planes at once than this only where a tree says the same twice.
    std::array<std::uint32_t, 16> others{};
    std::size_t otherCount = 0;
    std::uint32_t node = 0;
    // Children follow their parents, but the bound costs nothing.
    for (std::uint32_t steps = 0; steps < space.bspNodeCount; ++steps) {
        if (node >= space.bspNodeCount) {
            if (otherCount == 0)
                return false;
            node = others[--otherCount];
        }
        const world::CellBspNode& at = world.cellBspNodes[space.firstBspNode + node];
        const double distance = at.plane.signedDistance(position);
        const bool isInFront = distance >= -kPlaneSlack;
        if (isInFront && at.positive == world::kNone)
            return true;
        if (isInFront && distance <= kPlaneSlack && at.negative != world::kNone && otherCount < others.size())
            others[otherCount++] = at.negative;
        node = isInFront ? at.positive : at.negative;
    }
    return false;
}

Located locate(const world::World& world, const Vec3& position) {
    Located located;
    for (world::SpaceIndex i = 1; i < world.spaces.size(); ++i) {
        if (!world.spaces[i].ofBuilding || !cellContains(world, i, position))
            continue;
        if (located.space != world::kOutside) {
            located.ambiguous = true;
            break;
        }
        located.space = i;
    }
    return located;
}

world::SpaceIndex sweep(const world::World& world, world::SpaceIndex space, const Vec3& from,
                        const Vec3& to) {
    if (space >= world.spaces.size() || !isFinite(from) || !isFinite(to))
        return space;
    Vec3 at = from;
    world::PortalIndex came = world::kNone;
    // A straight line passes no plane twice, so no portal twice.
    for (std::size_t steps = 0; steps <= world.portals.size(); ++steps) {
        Crossing first;
        const world::Space& current = world.spaces[space];
        for (world::PortalIndex p = current.firstPortal; p < current.firstPortal + current.portalCount; ++p) {
            const world::Portal& portal = world.portals[p];
            if (portal.destination == world::kNone || p == came)
                continue;
            const std::optional<double> t = crossingOf(world, portal, at, to);
            if (t && *t < first.t)
                first = {*t, p};
        }
        if (first.portal == world::kNone)
            return space;
        const world::Portal& passed = world.portals[first.portal];
        at = at + (to - at) * first.t;
        came = passed.reciprocal;
        space = passed.destination;
    }
    return space;
}

} // namespace limen::motion
