#pragma once

#include <algorithm>

namespace limen::visibility {

/// A screen-aligned rectangle in NDC.
struct Rect {
    double minX = 1e300, minY = 1e300, maxX = -1e300, maxY = -1e300; ///< empty until it includes a point

    [[nodiscard]] bool empty() const { return minX > maxX || minY > maxY; }
    void include(double x, double y) {
        minX = std::min(minX, x);
        maxX = std::max(maxX, x);
        minY = std::min(minY, y);
        maxY = std::max(maxY, y);
    }
};

[[nodiscard]] inline Rect intersection(const Rect& a, const Rect& b) {
    return {std::max(a.minX, b.minX), std::max(a.minY, b.minY), std::min(a.maxX, b.maxX),
            std::min(a.maxY, b.maxY)};
}

} // namespace limen::visibility
