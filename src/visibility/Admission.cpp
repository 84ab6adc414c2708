#include "visibility/Admission.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"
#include "visibility/EyeSpace.h"
#include "visibility/Outline.h"
#include "visibility/Region.h"

#include <algorithm>
#include <limits>

namespace limen::visibility {

namespace {

/// Distances of a polygon's corners beyond a visit's entry plane, metres.
struct Extent {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
    void include(double distance) {
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
};

/// True if rays that come in by the entry plane may leave by a portal of this extent. A portal in the plane faces
/// them if the space has no depth there: its walls touch, or slivers of its openings do.
bool isReached(const Plane& entry, const Graph::Portal& portal, const Extent& beyond) {
    const bool facesBack = glm::dot(entry.n, portal.plane.n) < 0.0;
    return beyond.most > kBeyondEntry || (facesBack && beyond.least >= -kBeyondEntry);
}

/// A bit of 64 by hash.
std::uint64_t bitOf(std::uint32_t portal) {
    return std::uint64_t{1} << (portal * 0x9E3779B1u >> 26);
}

/// True if the regions differ by rounding only.
bool isSameRegion(std::span<const Vec3> before, std::span<const Vec3> after) {
    constexpr double kRounding = 1e-12; // radians
    return std::equal(
        before.begin(), before.end(), after.begin(), after.end(),
        [](const Vec3& a, const Vec3& b) { return glm::dot(a - b, a - b) <= kRounding * kRounding; });
}

} // namespace

template <bool kTraced>
void Admission::admit(std::uint32_t index, std::uint32_t portalIndex, const ScreenOpenings::Exit* known,
                      CandidateList& children) {
    const Visit& visit = set_.visits[index];
    const Graph::Portal& portal = in_.graph.portals()[portalIndex];
    const auto refuse = [&](PortalFate why) { note<kTraced>(in_.trace, index, portalIndex, why); };
    const bool isShut = !in_.closed.empty() && in_.closed[portalIndex] != 0;
    const bool isEnd = isShut || portal.destination == kNone;
    if (portal.plane.n == Vec3(0.0))
        return refuse(PortalFate::NoArea);
    if (isWayBack(visit, portalIndex))
        return refuse(PortalFate::WayBack);
    if (!isEnd && in_.graph.spaces()[portal.destination].zone == visit.zone) {
        if (portal.destination == portal.space) // CellFlood traces the others
            refuse(PortalFate::WithinZone);
        return;
    }
    const double side = portal.plane.signedDistance(in_.view.eye);
    if (side < -kInPlaneTolerance)
        return refuse(PortalFate::WrongSide);
    ++set_.counts.portalsTested;
    const bool inPlane =
        in_.rules.halfPlane && visit.inPlane && isLeftAtEye(in_.graph, portalIndex, in_.view.eye);
    if (inPlane && !isShut)
        admitAtEye<kTraced>(index, portalIndex, children);
    // From another space of the zone the rays come to the opening later.
    const bool isLeft = inPlane && portal.space == visit.space;
    if (isLeft ? isShut : side <= 0.0)
        return refuse(PortalFate::EdgeOn); // or seen from behind: no ray of this visit passes
    if (isLeft)
        return;
    if (openingRegion(index, portal, known))
        return leave<kTraced>(index, portalIndex, false, children);
    if constexpr (kTraced)
        refuse(whyUnseen(index, portalIndex));
}

/// The candidates for rays that leave by the portal at the eye.
template <bool kTraced>
void Admission::admitAtEye(std::uint32_t index, std::uint32_t portal, CandidateList& children) {
    const Visit& visit = set_.visits[index];
    s_.paths.find(in_, visit, set_.region(visit), portal);
    for (const std::vector<Vec3>& region : s_.paths.found()) {
        s_.region.assign(region.begin(), region.end());
        leave<kTraced>(index, portal, true, children);
    }
    if constexpr (kTraced)
        if (s_.paths.found().empty())
            note<kTraced>(in_.trace, index, portal, whyUnseen(index, portal));
}

/// Appends the candidates for the rays in s_.region.
template <bool kTraced>
void Admission::leave(std::uint32_t index, std::uint32_t portalIndex, bool inPlane, CandidateList& children) {
    const Visit& visit = set_.visits[index];
    const Graph::Portal& portal = in_.graph.portals()[portalIndex];
    if (smallest_ > 0.0 && coneSize(s_.region) < smallest_) {
        ++set_.counts.visitsCut;
        return note<kTraced>(in_.trace, index, portalIndex, PortalFate::Budget);
    }
    if (isInChain(index, portalIndex)) // last, because few openings get this far
        return note<kTraced>(in_.trace, index, portalIndex, PortalFate::InChain);
    ++set_.counts.portalsAdmitted;
    Candidate c;
    c.portal = portalIndex;
    c.parent = index;
    c.entryPlane = portal.plane.relativeTo(in_.view.eye).flipped();
    c.planeOnScreen = in_.eyeFromScreenTransposed * c.entryPlane.n;
    c.inPlane = inPlane;
    c.shut = !in_.closed.empty() && in_.closed[portalIndex] != 0;
    if (c.shut || portal.destination == kNone)
        add(c, true, children);
    else
        addPair(visit, c, children);
}

PortalFate Admission::whyUnseen(std::uint32_t index, std::uint32_t portalIndex) const {
    const Visit& visit = set_.visits[index];
    const Graph::Portal& portal = in_.graph.portals()[portalIndex];
    if (portal.plane.n == Vec3(0.0))
        return PortalFate::NoArea;
    if (isWayBack(visit, portalIndex))
        return PortalFate::WayBack;
    if (portal.plane.signedDistance(in_.view.eye) < -kInPlaneTolerance)
        return PortalFate::WrongSide;
    Extent beyond;
    bool isAhead = false;
    for (const Vec3& v : in_.graph.polygon(portal)) {
        beyond.include(visit.entryPlane.signedDistance(v - in_.view.eye));
        isAhead |= glm::dot(in_.view.forward, v - in_.view.eye) > 0.0;
    }
    if (!isAhead)
        return PortalFate::BehindEye;
    return isReached(visit.entryPlane, portal, beyond) ? PortalFate::OutsideRegion : PortalFate::BeforeEntry;
}

template void Admission::admit<false>(std::uint32_t, std::uint32_t, const ScreenOpenings::Exit*,
                                      CandidateList&);
template void Admission::admit<true>(std::uint32_t, std::uint32_t, const ScreenOpenings::Exit*,
                                     CandidateList&);

/// Adds the opening, and the hole that an inexact pair leaves around it.
void Admission::addPair(const Visit& visit, Candidate c, CandidateList& children) {
    const Graph::Portal& portal = in_.graph.portals()[c.portal];
    if (isCutByReciprocal(visit, portal)) {
        s_.whole.assign(s_.region.begin(), s_.region.end());
        clipByReciprocal(in_.graph.portals()[portal.reciprocal]);
        if (!isSameRegion(s_.whole, s_.region)) {
            s_.region.swap(s_.whole);
            add(c, true, children);
            s_.region.swap(s_.whole);
            c.narrowed = true;
        }
    }
    if (!s_.region.empty())
        add(c, false, children);
}

/// Adds a child with the region in s_.region.
void Admission::add(Candidate c, bool hole, CandidateList& children) const {
    c.hole = hole;
    c.rect = boundsOf(s_.region);
    children.add(c, s_.region);
}

/// True if the reciprocal's polygon bounds the opening, too. An eye inside the reciprocal is already through
/// it.
bool Admission::isCutByReciprocal(const Visit& visit, const Graph::Portal& portal) const {
    return !portal.exact && portal.reciprocal != kNone &&
           !(in_.rules.halfPlane && visit.inPlane &&
             holdsEye(in_.graph, in_.graph.portals()[portal.reciprocal], in_.view.eye, -1.0));
}

bool Admission::isWayBack(const Visit& visit, std::uint32_t portal) const {
    return visit.portal != kNone && in_.graph.portals()[visit.portal].reciprocal == portal;
}

void Admission::summarise(std::uint32_t index, const Rect& rect) {
    const Visit& visit = set_.visits[index];
    const bool isRoot = visit.parent == kNone;
    s_.summaries.resize(index);
    s_.summaries.push_back({rect, isRoot ? 0 : s_.summaries[visit.parent].chain | bitOf(visit.portal)});
}

/// A straight ray crosses a plane once. But a polygon that is not flat extends beyond its plane, and without
/// this test rays could follow a ring of such openings for ever.
bool Admission::isInChain(std::uint32_t visit, std::uint32_t portal) const {
    if ((s_.summaries[visit].chain & bitOf(portal)) == 0)
        return false;
    for (; visit != kNone; visit = set_.visits[visit].parent)
        if (set_.visits[visit].portal == portal)
            return true;
    return false;
}

/// The part of the opening that the visit's rays reach, into s_.region.
bool Admission::openingRegion(std::uint32_t index, const Graph::Portal& portal,
                              const ScreenOpenings::Exit* known) {
    const Visit& visit = set_.visits[index];
    if (known != nullptr && intersection(known->rect, s_.summaries[index].rect).empty())
        return false;
    std::span<const Vec3> relative;
    if (known != nullptr) {
        relative = openings_.relative(*known);
    } else if (portal.outlineCount > 0) {
        hullSeenFrom(in_.view.eye, in_.graph.outline(portal), portal.plane.n, s_.relative, s_.swap);
        relative = s_.relative;
    } else {
        s_.relative.clear();
        for (const Vec3& v : in_.graph.polygon(portal))
            s_.relative.push_back(v - in_.view.eye);
        relative = s_.relative;
    }
    Extent beyond;
    for (const Vec3& v : relative)
        beyond.include(visit.entryPlane.signedDistance(v));
    if (!isReached(visit.entryPlane, portal, beyond))
        return false;
    if (known != nullptr && beyond.least >= -kInPlaneTolerance && in_.rules.eyePlaneClip) {
        clipByRegion(openings_.onScreen(*known), set_.region(visit), s_.region, s_.swap);
        return !s_.region.empty();
    }
    // The part within the tolerance of the entry plane is kept: corners that two openings share are not
    // exactly in the planes of both.
    clipPolygon(relative, visit.entryPlane, kInPlaneTolerance, s_.beyond);
    if (!in_.rules.eyePlaneClip) {
        clipPolygon(s_.beyond, {in_.view.forward, -kNearestPlace}, 0.0, s_.swap);
        s_.beyond.swap(s_.swap);
    }
    for (Vec3& v : s_.beyond)
        v = in_.screen * v;
    clipByRegion(s_.beyond, set_.region(visit), s_.region, s_.swap);
    return !s_.region.empty();
}

/// An inexact pair is open where both polygons are.
void Admission::clipByReciprocal(const Graph::Portal& reciprocal) {
    s_.relative.clear();
    if (reciprocal.plane.n == Vec3(0.0)) {
        s_.region.clear();
        return;
    }
    for (const Vec3& v : in_.graph.polygon(reciprocal))
        s_.relative.push_back(in_.screen * (v - in_.view.eye));
    // Its winding is counter-clockwise from the other side, so it is reversed.
    std::reverse(s_.relative.begin(), s_.relative.end());
    s_.beyond.assign(s_.region.begin(), s_.region.end());
    clipByRegion(s_.beyond, s_.relative, s_.region, s_.swap);
}

} // namespace limen::visibility
