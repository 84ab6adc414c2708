#include "visibility/EyeSpace.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"

#include <cmath>

namespace limen::visibility {

namespace {

/// Openings that meet in a corner: more than this many are not passed within a fifth of a millimetre.
constexpr int kMostPassed = 4;

bool isInside(const Graph& graph, const Graph::Portal& portal, const Vec3& eye) {
    return containsProjection(graph.polygon(portal), portal.plane.n, eye, 0.0);
}

/// An inexact pair has been passed only if the eye is through its other polygon, too.
bool isPassed(const Graph& graph, const Graph::Portal& portal, const Vec3& eye) {
    const double side = portal.plane.signedDistance(eye);
    if (portal.destination == kNone || portal.plane.n == Vec3(0.0) || side >= -portal.inPlane ||
        side < -kInPlaneTolerance || !isInside(graph, portal, eye))
        return false;
    if (portal.exact || portal.reciprocal == kNone)
        return true;
    const Graph::Portal& back = graph.portals()[portal.reciprocal];
    return back.plane.signedDistance(eye) > 0.0 && isInside(graph, back, eye);
}

} // namespace

bool isNearestOpening(const Graph& graph, std::uint32_t index, const Vec3& eye) {
    const Graph::Portal& portal = graph.portals()[index];
    const Graph::Space& here = graph.spaces()[portal.space];
    const double distance = std::abs(portal.plane.signedDistance(eye));
    for (std::uint32_t p = here.firstPortal; p < here.firstPortal + here.portalCount; ++p) {
        const Graph::Portal& other = graph.portals()[p];
        if (p != index && other.destination == portal.destination &&
            std::abs(other.plane.signedDistance(eye)) < distance && isInside(graph, other, eye))
            return false;
    }
    return true;
}

bool holdsEye(const Graph& graph, const Graph::Portal& portal, const Vec3& eye, double way) {
    const double side = way * portal.plane.signedDistance(eye);
    return side >= -kInPlaneTolerance && side <= portal.inPlane && isInside(graph, portal, eye);
}

bool isLeftAtEye(const Graph& graph, std::uint32_t index, const Vec3& eye) {
    const Graph::Portal& portal = graph.portals()[index];
    return portal.plane.n != Vec3(0.0) && holdsEye(graph, portal, eye, 1.0) &&
           (portal.plane.signedDistance(eye) >= -portal.inPlane || isNearestOpening(graph, index, eye));
}

std::uint32_t spaceOfEye(const Graph& graph, const Vec3& eye, std::uint32_t root) {
    std::uint32_t space = root, cameBy = kNone;
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const Graph::Space& here = graph.spaces()[space];
        std::uint32_t next = kNone;
        for (std::uint32_t p = here.firstPortal; p < here.firstPortal + here.portalCount && next == kNone;
             ++p) {
            const bool isBack = cameBy != kNone && graph.portals()[cameBy].reciprocal == p;
            if (!isBack && isPassed(graph, graph.portals()[p], eye) && isNearestOpening(graph, p, eye))
                next = p;
        }
        if (next == kNone)
            break;
        cameBy = next;
        space = graph.portals()[next].destination;
    }
    return space;
}

} // namespace limen::visibility
