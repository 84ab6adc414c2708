#include "motion/Locate.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"

#include <algorithm>
#include <array>
#include <optional>

namespace limen::motion {
namespace {

/// The point and the portal by which a segment leaves a space.
struct Crossing {
    double t = 2.0; ///< along the segment
    world::PortalIndex portal = world::kNone;
};

/// The parameter at which a segment leaves a space through an opening, if it does. A segment that starts in
/// the portal's plane, or up to the tolerance behind it, and leads away from the space, passes at 0.
std::optional<double> crossingOf(const world::World& world, const world::Portal& portal, const Vec3& from,
                                 const Vec3& to) {
    const double before = portal.plane.signedDistance(from), after = portal.plane.signedDistance(to);
    if (portal.plane.n == Vec3(0.0) || before < -kInPlaneTolerance || after >= 0.0 || after >= before)
        return std::nullopt;
    const double t = std::clamp(before / (before - after), 0.0, 1.0);
    const Vec3 at = from + (to - from) * t;
    if (!containsProjection(world::cornersOf(world, portal), portal.plane.n, at, kGapTolerance))
        return std::nullopt;
    return t;
}

} // namespace

bool cellContains(const world::World& world, world::SpaceIndex index, const Vec3& position) {
    if (index >= world.spaces.size() || !isFinite(position))
        return false;
    const world::Space& space = world.spaces[index];
    // Nodes whose plane contains the point: their front side is tried first, and these back sides later. A
    // point is in more than 16 such planes only if the tree repeats a plane.
    std::array<std::uint32_t, 16> others{};
    std::size_t otherCount = 0;
    std::uint32_t node = 0;
    // Children come after their parents, so the walk ends by itself. The bound guards against a damaged tree.
    for (std::uint32_t steps = 0; steps < space.bspNodeCount; ++steps) {
        if (node >= space.bspNodeCount) {
            if (otherCount == 0)
                return false;
            node = others[--otherCount];
        }
        const world::CellBspNode& at = world.cellBspNodes[space.firstBspNode + node];
        const double distance = at.plane.signedDistance(position);
        const bool isInFront = distance >= -kInPlaneTolerance;
        if (isInFront && at.positive == world::kNone)
            return true;
        if (isInFront && distance <= kInPlaneTolerance && at.negative != world::kNone &&
            otherCount < others.size())
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
    // A straight line crosses each plane once, so it passes each portal once.
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
