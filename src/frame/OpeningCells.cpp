#include "frame/OpeningCells.h"

#include "frame/ZoneScreenRects.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace limen::frame {

namespace {

constexpr int kCells = 16; ///< columns, and rows

/// The cells that openings touch: a bit for each column of each row, from the lower left.
using Touched = std::array<std::uint16_t, kCells>;

int cellAt(float ndc) {
    return static_cast<int>(std::floor(std::clamp((ndc + 1.0f) * (kCells / 2.0f), -1.0f, float{kCells})));
}

void touch(const gpu::vec4& rect, Touched& touched) {
    const int left = std::max(cellAt(rect.x), 0), right = std::min(cellAt(rect.z), kCells - 1);
    const int low = std::max(cellAt(rect.y), 0), high = std::min(cellAt(rect.w), kCells - 1);
    if (left > right)
        return;
    const auto columns = static_cast<std::uint16_t>((2u << right) - (1u << left));
    for (int row = low; row <= high; ++row)
        touched[static_cast<std::size_t>(row)] |= columns;
}

float ndcOf(int cell) {
    return static_cast<float>(cell) * (2.0f / kCells) - 1.0f; // exact
}

/// Adds the rectangles of one row's bits, which are `height` cells high.
void addRow(std::uint16_t bits, int row, int height, std::vector<gpu::vec4>& rects) {
    for (int at = 0; at < kCells;) {
        const auto rest = static_cast<std::uint16_t>(bits >> at);
        const int gap = std::countr_zero(rest);
        if (gap >= kCells)
            return;
        const int wide = std::countr_one(static_cast<std::uint16_t>(rest >> gap));
        rects.emplace_back(ndcOf(at + gap), ndcOf(row), ndcOf(at + gap + wide), ndcOf(row + height));
        at += gap + wide;
    }
}

RectRun addRects(const Touched& touched, FramePlan& plan) {
    const std::size_t first = plan.rects.size();
    for (int row = 0; row < kCells;) {
        const std::uint16_t bits = touched[static_cast<std::size_t>(row)];
        int end = row + 1;
        while (end < kCells && touched[static_cast<std::size_t>(end)] == bits)
            ++end;
        addRow(bits, row, end - row, plan.rects);
        row = end;
    }
    return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(plan.rects.size() - first)};
}

constexpr std::size_t kMostRects = std::size_t{kCells} * kCells;

} // namespace

RectRun rectsOfOpenings(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
    Touched touched{};
    for (const visibility::Visit& visit : set.visits)
        if (visit.depth == 1) // those behind them are within their regions
            touch(rectAround(frame, set, visit), touched);
    if (plan.rects.size() + kMostRects > kMaxFirstRect)
        touched.fill(0xFFFF);
    return addRects(touched, plan);
}

double shareOf(const RectRun& rects, const FramePlan& plan) {
    double area = 0.0; // NDC
    for (std::size_t i = rects.first; i < std::size_t{rects.first} + rects.count; ++i)
        area += double{plan.rects[i].z - plan.rects[i].x} * double{plan.rects[i].w - plan.rects[i].y};
    return area / 4.0;
}

} // namespace limen::frame
