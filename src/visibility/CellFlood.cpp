#include "visibility/CellFlood.h"

#include <algorithm>

namespace limen::visibility {

namespace {

/// Waiting rectangles of one cell are merged if the union is at most this many times as large as both
/// together. Neighbouring cells of a hall pass adjacent rectangles to the next cell, and following each alone
/// costs more with every cell.
constexpr double kMostWaste = 1.5;

} // namespace

void CellFlood::run(const Input& input, const Graph& graph, ScreenOpenings& openings,
                    std::vector<SeenSpace>& seen, FloodCounts& counts) {
    marks_.resize(graph.spaces().size());
    ++stamp_;
    if (stamp_ == 0) { // wrapped around: clear all marks
        std::fill(marks_.begin(), marks_.end(), Mark{});
        stamp_ = 1;
    }
    visit_ = input.visit;
    firstSeen_ = seen.size();
    head_ = tail_ = 0;
    enterFirst(input.entrySpace, input.entryRect, seen);
    if (input.trace != nullptr)
        follow<true>(input, openings, seen, counts);
    else
        follow<false>(input, openings, seen, counts);
}

template <bool kTraced>
void CellFlood::follow(const Input& input, ScreenOpenings& openings, std::vector<SeenSpace>& seen,
                       FloodCounts& counts) {
    while (head_ < tail_) {
        const Arrival from = queue_[head_++]; // by value: the queue grows
        const ScreenOpenings::Space& space = openings.of(from.space);
        ++counts.spaceVisits;
        counts.portalsTested += space.tested;
        const RectLanes rect(from.rect);
        for (const ScreenOpenings::Inner& opening : openings.inner(space)) {
            const RectLanes through = rect.intersection(opening.rect);
            const bool isOutside = through.empty();
            note<kTraced>(input.trace, visit_, opening.portal,
                          isOutside ? opening.refusal : PortalFate::WithinZone);
            if (isOutside)
                continue;
            ++counts.portalsAdmitted;
            enter(opening.destination, through, seen, counts);
        }
    }
}

void CellFlood::push(std::uint32_t space, const Rect& rect) {
    if (tail_ == queue_.size())
        queue_.resize(2 * tail_ + 16);
    queue_[tail_++] = {space, rect};
}

void CellFlood::enterFirst(std::uint32_t space, const RectLanes& rect, std::vector<SeenSpace>& seen) {
    const std::size_t index = seen.size() - firstSeen_;
    marks_[space] = {stamp_, static_cast<std::uint32_t>(index)};
    if (cells_.size() == index)
        cells_.emplace_back();
    Cell& cell = cells_[index];
    cell.count = 1;
    cell.rects[0] = rect.rect();
    cell.arrivals[0] = static_cast<std::uint32_t>(tail_);
    seen.push_back({space, visit_, rect.rect()});
    push(space, rect.rect());
}

void CellFlood::enter(std::uint32_t space, const RectLanes& rect, std::vector<SeenSpace>& seen,
                      FloodCounts& counts) {
    const Mark mark = marks_[space];
    if (mark.stamp != stamp_) {
        enterFirst(space, rect, seen);
        return;
    }
    Cell& cell = cells_[mark.cell];
    for (std::uint32_t i = 0; i < cell.count; ++i)
        if (RectLanes(cell.rects[i]).contains(rect))
            return;
    Rect& whole = seen[firstSeen_ + mark.cell].rect;
    whole = RectLanes(whole).unionWith(rect).rect();
    if (mergeWaiting(cell, rect))
        return;
    ++counts.revisits;
    const Rect entered = cell.count < kRects ? rect.rect() : whole;
    cell.count = std::min(cell.count + 1, kRects);
    cell.rects[cell.count - 1] = entered;
    cell.arrivals[cell.count - 1] = static_cast<std::uint32_t>(tail_);
    push(space, entered);
}

bool CellFlood::mergeWaiting(Cell& cell, const RectLanes& rect) {
    for (std::uint32_t i = 0; i < cell.count; ++i) {
        if (cell.arrivals[i] < head_)
            continue; // already followed
        const RectLanes waiting(cell.rects[i]);
        const RectLanes both = waiting.unionWith(rect);
        if (both.area() <= kMostWaste * (waiting.area() + rect.area())) {
            cell.rects[i] = both.rect();
            queue_[cell.arrivals[i]].rect = both.rect();
            return true;
        }
    }
    return false;
}

} // namespace limen::visibility
