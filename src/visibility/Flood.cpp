#include "visibility/Flood.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "visibility/CellFlood.h"
#include "visibility/Outline.h"
#include "visibility/Region.h"
#include "visibility/SiblingOrder.h"

#include <algorithm>

namespace limen::visibility {

/// Everything a flood works in, kept between floods for its capacity.
struct FloodScratch::Data {
    CellFlood cells;
    SiblingOrder order;
    CandidateList pending;  ///< a stack: the top is the next visit in drawing order
    CandidateList children; ///< of the visit at hand
    std::vector<Vec3> relative, beyond, region, whole, swap;
    std::vector<std::uint32_t> nodes;
};

FloodScratch::FloodScratch() : data_(std::make_unique<Data>()) {}
FloodScratch::~FloodScratch() = default;
FloodScratch::FloodScratch(FloodScratch&&) noexcept = default;
FloodScratch& FloodScratch::operator=(FloodScratch&&) noexcept = default;

namespace {

/// A portal must reach this far beyond the plane its visit was entered by, in metres: a ray that enters
/// through a plane does not leave through the same plane (two openings in one wall).
constexpr double kBeyondEntry = 1e-6;

/// Where openings are cut with Rules::eyePlaneClip off, metres.
constexpr double kPretendedNear = 0.02;

/// True if clipping has taken nothing away but rounding.
bool isSameRegion(std::span<const Vec3> before, std::span<const Vec3> after) {
    constexpr double kRounding = 1e-12; // radians
    return std::equal(
        before.begin(), before.end(), after.begin(), after.end(),
        [](const Vec3& a, const Vec3& b) { return glm::dot(a - b, a - b) <= kRounding * kRounding; });
}

/// One flood: the depth-first walk over visits.
class Walk {
public:
    Walk(const Graph& graph, std::span<const std::uint8_t> closed, const View& view, const Rules& rules,
         FloodScratch::Data& scratch, VisibleSet& out, double smallest)
        : graph_(graph), closed_(closed), view_(view), screen_(view.screenFromEye()),
          eyeFromScreenTransposed_(glm::inverse(glm::transpose(screen_))), rules_(rules), s_(scratch),
          out_(out), smallest_(smallest) {}

    /// False if more than `maxVisits` visits are needed; `out` is then incomplete.
    bool run(std::uint32_t maxVisits) {
        addRoot();
        visitSpaces(0);
        while (!s_.pending.items.empty()) {
            if (out_.visits.size() >= maxVisits) {
                return false;
            }
            const std::uint32_t next = popPending();
            if (!out_.visits[next].hole) {
                visitSpaces(next);
            }
        }
        return true;
    }

private:
    void addRoot() {
        Visit root;
        root.zone = graph_.spaces()[view_.root].zone;
        root.space = view_.root;
        root.vertexCount = 4;
        root.inPlane = true; // the ray has not moved yet: the in-plane rule applies to what leads out of here
        out_.visits.push_back(root);
        out_.regionVertices.insert(out_.regionVertices.end(),
                                   {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
    }

    std::uint32_t popPending() {
        const Candidate c = s_.pending.items.back();
        const Graph::Portal& portal = graph_.portals()[c.portal];
        Visit visit;
        visit.space = c.hole ? kNone : portal.destination;
        visit.zone = c.hole ? kNoZone : graph_.spaces()[portal.destination].zone;
        visit.parent = c.parent;
        visit.portal = c.portal;
        visit.entryPlane = c.entryPlane;
        visit.firstVertex = static_cast<std::uint32_t>(out_.regionVertices.size());
        visit.vertexCount = c.vertexCount;
        visit.depth = out_.visits[c.parent].depth + 1;
        visit.inPlane = c.inPlane;
        visit.hole = c.hole;
        visit.shut = c.shut;
        visit.narrowed = c.narrowed;
        visit.split = c.split;
        const auto region = s_.pending.region(c);
        out_.regionVertices.insert(out_.regionVertices.end(), region.begin(), region.end());
        s_.pending.vertices.resize(c.firstVertex);
        s_.pending.items.pop_back();
        out_.visits.push_back(visit);
        return static_cast<std::uint32_t>(out_.visits.size() - 1);
    }

    /// Floods the visit's zone, collects the openings out of it and stacks them, far first on top.
    void visitSpaces(std::uint32_t index) {
        const Visit visit = out_.visits[index];
        const std::size_t firstSeen = out_.seen.size();
        const Rect entryRect = boundsOf(out_.region(visit));
        s_.cells.run({&graph_, closed_, view_.eye, screen_, index, visit.space, visit.portal, entryRect},
                     out_.seen, out_.counts);
        s_.children.clear();
        for (std::size_t i = firstSeen; i < out_.seen.size(); ++i) {
            openingsOf(index, out_.seen[i]);
        }
        if (rules_.siblingOrder) {
            s_.order.sort(s_.children, out_.counts);
        }
        for (std::size_t i = s_.children.items.size(); i-- > 0;) {
            const Candidate& c = s_.children.items[i];
            s_.pending.add(c, s_.children.region(c));
        }
    }

    void openingsOf(std::uint32_t visit, const SeenSpace& seen) {
        const Graph::Space& space = graph_.spaces()[seen.space];
        if (space.root == kNone) {
            for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
                tryOpening(visit, p);
            }
            return;
        }
        s_.nodes.assign(1, space.root);
        while (!s_.nodes.empty()) {
            const Graph::BoundsNode& node = graph_.boundsNodes()[s_.nodes.back()];
            s_.nodes.pop_back();
            if (!mayBeSeen(visit, node.box)) {
                continue;
            }
            if (node.child == kNone) {
                tryOpening(visit, node.portal);
            } else {
                s_.nodes.push_back(node.child);
                s_.nodes.push_back(node.child + 1);
            }
        }
    }

    /// False only if the box lies outside one edge of the visit's region, or before its entry plane.
    [[nodiscard]] bool mayBeSeen(std::uint32_t index, const Aabb& box) const {
        const Visit& visit = out_.visits[index];
        const Vec3 centre = box.centre() - view_.eye;
        const Vec3 half = (box.max - box.min) * 0.5;
        const auto behind = [&](const Vec3& n, double d) {
            return glm::dot(n, centre) + d + glm::dot(glm::abs(n), half) < 0.0;
        };
        if (behind(visit.entryPlane.n, visit.entryPlane.d)) {
            return false;
        }
        const auto region = out_.region(visit);
        const Mat3 eyeFromScreenNormal = glm::transpose(screen_);
        for (std::size_t i = 0; i < region.size(); ++i) {
            const Vec3 edge = glm::cross(region[i], region[i + 1 == region.size() ? 0 : i + 1]);
            if (behind(eyeFromScreenNormal * edge, 0.0)) {
                return false;
            }
        }
        return true;
    }

    void tryOpening(std::uint32_t index, std::uint32_t portalIndex) {
        const Visit& visit = out_.visits[index];
        const Graph::Portal& portal = graph_.portals()[portalIndex];
        const bool isShut = !closed_.empty() && closed_[portalIndex] != 0;
        const bool isEnd = isShut || portal.destination == kNone;
        if (portal.plane.n == Vec3(0.0) || isWayBack(visit, portalIndex) ||
            (!isEnd && graph_.spaces()[portal.destination].zone == visit.zone)) {
            return;
        }
        const double side = portal.plane.signedDistance(view_.eye);
        if (side < -kInPlane) {
            return;
        }
        ++out_.counts.portalsTested;
        const bool inPlane = rules_.halfPlane && visit.inPlane && holdsEye(portal, 1.0);
        if (inPlane ? isShut : side <= 0.0) {
            return; // edge-on or from behind: no ray of this visit passes
        }
        if (inPlane ? !halfRegion(visit, portal) : !openingRegion(visit, portal)) {
            return;
        }
        if (coneSize(s_.region) < smallest_) {
            ++out_.counts.visitsCut;
            return;
        }
        if (isInChain(index, portalIndex)) { // asked last: few get this far
            return;
        }
        ++out_.counts.portalsAdmitted;
        Candidate c;
        c.portal = portalIndex;
        c.parent = index;
        c.entryPlane = portal.plane.relativeTo(view_.eye).flipped();
        c.planeOnScreen = eyeFromScreenTransposed_ * c.entryPlane.n;
        c.inPlane = inPlane;
        if (isEnd) {
            c.shut = isShut;
            addChild(c, true);
            return;
        }
        if (isCutByReciprocal(visit, portal)) {
            s_.whole.assign(s_.region.begin(), s_.region.end());
            clipByReciprocal(graph_.portals()[portal.reciprocal]);
            if (!isSameRegion(s_.whole, s_.region)) {
                s_.region.swap(s_.whole);
                addChild(c, true);
                s_.region.swap(s_.whole);
                c.narrowed = true;
            }
        }
        if (!s_.region.empty()) {
            addChild(c, false);
        }
    }

    /// A child with the region in s_.region.
    void addChild(Candidate c, bool hole) {
        c.hole = hole;
        c.rect = boundsOf(s_.region);
        s_.children.add(c, s_.region);
    }

    /// True if the eye lies in the portal's plane, inside the opening. `way`: 1 for rays out of its space, -1 for those into it.
    [[nodiscard]] bool holdsEye(const Graph::Portal& portal, double way) const {
        const double side = way * portal.plane.signedDistance(view_.eye);
        return side >= -kInPlane && side <= portal.inPlane &&
               containsProjection(graph_.polygon(portal), portal.plane.n, view_.eye, 0.0);
    }

    /// True if the way back's polygon bounds the opening too. An eye inside that one is through it already.
    [[nodiscard]] bool isCutByReciprocal(const Visit& visit, const Graph::Portal& portal) const {
        return !portal.exact && portal.reciprocal != kNone &&
               !(rules_.halfPlane && visit.inPlane && holdsEye(graph_.portals()[portal.reciprocal], -1.0));
    }

    [[nodiscard]] bool isWayBack(const Visit& visit, std::uint32_t portal) const {
        return visit.portal != kNone && graph_.portals()[visit.portal].reciprocal == portal;
    }

    /// A straight ray crosses a plane once; but a polygon that is not flat reaches beyond its own plane, and rays could
    /// go round in a ring of such openings for ever.
    [[nodiscard]] bool isInChain(std::uint32_t visit, std::uint32_t portal) const {
        for (; visit != kNone; visit = out_.visits[visit].parent) {
            if (out_.visits[visit].portal == portal) {
                return true;
            }
        }
        return false;
    }

    /// The half of the visit's region on the far side of the portal's plane, into s_.region.
    bool halfRegion(const Visit& visit, const Graph::Portal& portal) {
        clipByEyePlane(out_.region(visit), eyeFromScreenTransposed_ * -portal.plane.n, s_.region);
        tidyRegion(s_.region);
        return !s_.region.empty();
    }

    /// The part of the opening that the visit's rays reach, into s_.region.
    bool openingRegion(const Visit& visit, const Graph::Portal& portal) {
        if (portal.outlineCount > 0) {
            hullSeenFrom(view_.eye, graph_.outline(portal), portal.plane.n, s_.relative, s_.swap);
        } else {
            s_.relative.clear();
            for (const Vec3& v : graph_.polygon(portal)) {
                s_.relative.push_back(v - view_.eye);
            }
        }
        double farthest = visit.parent == kNone ? 1.0 : 0.0;
        for (const Vec3& v : s_.relative) {
            farthest = std::max(farthest, visit.entryPlane.signedDistance(v));
        }
        if (farthest <= kBeyondEntry) {
            return false;
        }
        // What lies within the tolerance of the entry plane is met from both sides: corners that two openings share are
        // not quite in the planes of both.
        clipPolygon(s_.relative, visit.entryPlane, kInPlane, s_.beyond);
        if (!rules_.eyePlaneClip) {
            clipPolygon(s_.beyond, {view_.forward, -kPretendedNear}, 0.0, s_.swap);
            s_.beyond.swap(s_.swap);
        }
        for (Vec3& v : s_.beyond) {
            v = screen_ * v;
        }
        clipByRegion(s_.beyond, out_.region(visit), s_.region, s_.swap);
        return !s_.region.empty();
    }

    /// An inexact pair is open where both polygons are.
    void clipByReciprocal(const Graph::Portal& reciprocal) {
        s_.relative.clear();
        if (reciprocal.plane.n == Vec3(0.0)) {
            s_.region.clear();
            return;
        }
        for (const Vec3& v : graph_.polygon(reciprocal)) {
            s_.relative.push_back(screen_ * (v - view_.eye));
        }
        // Its winding is counter-clockwise from the other side; seen from here it must run the other way
        // round.
        std::reverse(s_.relative.begin(), s_.relative.end());
        s_.beyond.assign(s_.region.begin(), s_.region.end());
        clipByRegion(s_.beyond, s_.relative, s_.region, s_.swap);
    }

    const Graph& graph_;
    std::span<const std::uint8_t> closed_;
    const View& view_;
    Mat3 screen_;
    Mat3 eyeFromScreenTransposed_; ///< takes a plane's normal from eye-relative to (x, y, w)
    const Rules& rules_;
    FloodScratch::Data& s_;
    VisibleSet& out_;
    double smallest_;
};

} // namespace

void flood(const Graph& graph, std::span<const std::uint8_t> closed, const View& view, const Limits& limits,
           FloodScratch& scratch, VisibleSet& out) {
    LIMEN_ASSERT(view.root < graph.spaces().size(), "the root is not a space of the graph");
    LIMEN_ASSERT(isFinite(view.eye), "the eye is not finite");
    LIMEN_ASSERT(closed.empty() || closed.size() == graph.portals().size(), "one state for each portal");
    double smallest = 0.0;
    for (;;) {
        out.clear();
        scratch.data().pending.clear();
        if (Walk(graph, closed, view, limits.rules, scratch.data(), out, smallest)
                .run(std::max(limits.maxVisits, 1u))) {
            return;
        }
        // Too many: leave out the smallest openings, ever larger ones until the budget holds. Regions shrink
        // along a chain, so what is left is a tree, and the largest.
        smallest = smallest == 0.0 ? 1e-7 : smallest * 4.0;
    }
}

} // namespace limen::visibility
