#include "frame/ZoneScreenRects.h"

#include "visibility/Region.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Pixels by which a rectangle exceeds its region. Covers the difference between the region and the pixels
/// that its visit owns, with a margin: a ray passes a hundredth of a pixel beside the pixel's centre, and
/// floats are rounded.
constexpr double kMargin = 2.0;

gpu::vec4 aroundBoth(const gpu::vec4& a, const gpu::vec4& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.z, b.z), std::max(a.w, b.w)};
}

} // namespace

gpu::vec4 rectAround(const FrameView& frame, const visibility::VisibleSet& set,
                     const visibility::Visit& visit) {
    const visibility::Rect rect = visibility::boundsOf(set.region(visit));
    const double marginX = 2.0 * kMargin / frame.width, marginY = 2.0 * kMargin / frame.height;
    return {static_cast<float>(rect.minX - marginX), static_cast<float>(rect.minY - marginY),
            static_cast<float>(rect.maxX + marginX), static_cast<float>(rect.maxY + marginY)};
}

void ZoneScreenRects::find(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
    ++frame_;
    entries_.clear();
    for (std::uint32_t i = 0; i < set.visits.size() && set.visits.size() > 1; ++i)
        if (set.visits[i].zone < zones_.size()) // holes have no zone
            entries_.push_back({set.visits[i].zone, i});
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.zone != b.zone ? a.zone < b.zone : a.visit < b.visit;
    });
    for (const Entry& entry : entries_) {
        OfZone& of = zones_[entry.zone];
        const visibility::Visit& visit = set.visits[entry.visit];
        if (of.frame != frame_) {
            of = {frame_, {static_cast<std::uint16_t>(plan.rects.size()), 0}};
            if (visit.depth == 0 || plan.rects.size() > kMaxFirstRect) {
                of.rects = {};
                continue;
            }
        } else if (of.rects.count == 0) {
            continue;
        }
        if (of.rects.count < kMostRects) {
            plan.rects.push_back(rectAround(frame, set, visit));
            ++of.rects.count;
        } else {
            plan.rects.back() = aroundBoth(plan.rects.back(), rectAround(frame, set, visit));
        }
    }
}

} // namespace limen::frame
