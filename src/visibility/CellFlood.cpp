#include "visibility/CellFlood.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "visibility/Region.h"

#include <algorithm>

namespace limen::visibility {

namespace {

/// NDC by which rectangles are widened: an eighth of a pixel on a 4k screen. The rasteriser snaps vertices,
/// and a cell seen through a gap narrower than that must not be lost.
constexpr double kMargin = 1e-4;

/// Metres. An eye this near to a portal between two cells of a zone can be in either cell, and sees through
/// all of the portal.
constexpr double kNear = 0.01;

/// Metres. A point nearer to the eye plane is not projected: it is within kNear of the eye or off the screen.
constexpr double kMinW = 1e-6;

/// Waiting rectangles of one cell are merged if the union is at most this many times as large as both
/// together. Neighbouring cells of a hall pass adjacent rectangles to the next cell, and following each alone
/// costs more with every cell.
constexpr double kMostWaste = 1.5;

void include(Rect& rect, double x, double y) {
    rect.minX = std::min(rect.minX, x);
    rect.maxX = std::max(rect.maxX, x);
    rect.minY = std::min(rect.minY, y);
    rect.maxY = std::max(rect.maxY, y);
}

bool holds(const Rect& outer, const Rect& inner) {
    return inner.minX >= outer.minX && inner.maxX <= outer.maxX && inner.minY >= outer.minY &&
           inner.maxY <= outer.maxY;
}

void include(Rect& rect, const Rect& more) {
    include(rect, more.minX, more.minY);
    include(rect, more.maxX, more.maxY);
}

double areaOf(const Rect& r) {
    return (r.maxX - r.minX) * (r.maxY - r.minY);
}

} // namespace

void CellFlood::run(const Input& input, std::vector<SeenSpace>& seen, FloodCounts& counts) {
    marks_.resize(input.graph->spaces().size());
    ++stamp_;
    if (stamp_ == 0) { // wrapped around: clear all marks
        std::fill(marks_.begin(), marks_.end(), Mark{});
        stamp_ = 1;
    }
    visit_ = input.visit;
    queue_.clear();
    head_ = 0;
    enter(input.entrySpace, input.entryRect, seen, counts);
    while (head_ < queue_.size()) {
        const Arrival next = queue_[head_++]; // by value: the queue grows
        if (input.trace != nullptr)
            leave<true>(input, next, seen, counts);
        else
            leave<false>(input, next, seen, counts);
    }
}

void CellFlood::enter(std::uint32_t space, const Rect& rect, std::vector<SeenSpace>& seen,
                      FloodCounts& counts) {
    Mark& mark = marks_[space];
    if (mark.stamp != stamp_) {
        mark.stamp = stamp_;
        mark.slot = static_cast<std::uint32_t>(seen.size());
        mark.count = 1;
        mark.rects[0] = rect;
        mark.arrivals[0] = static_cast<std::uint32_t>(queue_.size());
        seen.push_back({space, visit_, rect});
        queue_.push_back({space, rect});
        return;
    }
    for (std::uint32_t i = 0; i < mark.count; ++i)
        if (holds(mark.rects[i], rect))
            return;
    include(seen[mark.slot].rect, rect);
    if (mergeWaiting(mark, rect))
        return;
    ++counts.revisits;
    const Rect entered = mark.count < kRects ? rect : seen[mark.slot].rect;
    mark.count = std::min(mark.count + 1, kRects);
    mark.rects[mark.count - 1] = entered;
    mark.arrivals[mark.count - 1] = static_cast<std::uint32_t>(queue_.size());
    queue_.push_back({space, entered});
}

bool CellFlood::mergeWaiting(Mark& mark, const Rect& rect) {
    for (std::uint32_t i = 0; i < mark.count; ++i) {
        if (mark.arrivals[i] < head_)
            continue; // already followed
        Rect both = mark.rects[i];
        include(both, rect);
        if (areaOf(both) <= kMostWaste * (areaOf(mark.rects[i]) + areaOf(rect))) {
            mark.rects[i] = both;
            queue_[mark.arrivals[i]].rect = both;
            return true;
        }
    }
    return false;
}

template <bool kTraced>
void CellFlood::leave(const Input& input, const Arrival& from, std::vector<SeenSpace>& seen,
                      FloodCounts& counts) {
    ++counts.spaceVisits;
    const Graph::Space& space = input.graph->spaces()[from.space];
    for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p)
        tryPortal<kTraced>(input, p, from.rect, seen, counts);
}

template <bool kTraced>
void CellFlood::tryPortal(const Input& input, std::uint32_t index, const Rect& rect,
                          std::vector<SeenSpace>& seen, FloodCounts& counts) {
    const Graph::Portal& portal = input.graph->portals()[index];
    if (portal.destination == kNone || portal.destination == portal.space ||
        input.graph->spaces()[portal.destination].zone != input.graph->spaces()[portal.space].zone)
        return;
    const auto trace = [&](PortalFate fate) { note<kTraced>(input.trace, visit_, index, fate); };
    const double side = portal.plane.signedDistance(input.eye);
    const auto isEnd = [&] {
        return (!input.closed.empty() && input.closed[index] != 0) || portal.plane.n == Vec3(0.0);
    };
    if (side < -kNear || isEnd()) {
        if (kTraced && !isEnd()) // Admission traces the others
            trace(PortalFate::WrongSide);
        return;
    }
    ++counts.portalsTested;
    Rect through = rect;
    const bool inside =
        side <= kNear && containsProjection(input.graph->polygon(portal), portal.plane.n, input.eye, kNear);
    if (!inside) {
        Rect opening;
        if (side <= 0.0)
            return trace(PortalFate::EdgeOn);
        if (!screenRect(input, portal, opening))
            return trace(PortalFate::BehindEye);
        through = intersection(rect, opening);
        if (through.empty())
            return trace(PortalFate::OutsideRegion);
    }
    ++counts.portalsAdmitted;
    trace(PortalFate::WithinZone);
    enter(portal.destination, through, seen, counts);
}

bool CellFlood::screenRect(const Input& input, const Graph::Portal& portal, Rect& rect) {
    const auto polygon = input.graph->polygon(portal);
    bool cut = false;
    for (const Vec3& vertex : polygon) {
        const Vec3 p = input.screenFromEye * (vertex - input.eye);
        if (p.z < kMinW) {
            cut = true;
            break;
        }
        const double inverse = 1.0 / p.z;
        include(rect, p.x * inverse, p.y * inverse);
    }
    if (cut) {
        rect = {};
        swap_.clear();
        for (const Vec3& vertex : polygon)
            swap_.push_back(input.screenFromEye * (vertex - input.eye));
        clipPolygon(swap_, Plane{Vec3(0, 0, 1), -kMinW}, 0.0, clipped_);
        for (const Vec3& p : clipped_)
            include(rect, p.x / p.z, p.y / p.z);
    }
    rect = {rect.minX - kMargin, rect.minY - kMargin, rect.maxX + kMargin, rect.maxY + kMargin};
    return !rect.empty();
}

} // namespace limen::visibility
