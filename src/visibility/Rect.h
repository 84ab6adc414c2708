#pragma once

#include <algorithm>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

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

#ifdef __SSE2__
/// A rectangle in vector registers. No operation has a branch, because most outcomes are unpredictable.
class RectLanes {
public:
    RectLanes(const Rect& rect) : min_(_mm_loadu_pd(&rect.minX)), max_(_mm_loadu_pd(&rect.maxX)) {}
    [[nodiscard]] Rect rect() const {
        Rect rect;
        _mm_storeu_pd(&rect.minX, min_);
        _mm_storeu_pd(&rect.maxX, max_);
        return rect;
    }
    [[nodiscard]] bool empty() const { return _mm_movemask_pd(_mm_cmpgt_pd(min_, max_)) != 0; }
    [[nodiscard]] bool contains(const RectLanes& inner) const {
        return _mm_movemask_pd(_mm_and_pd(_mm_cmpge_pd(inner.min_, min_), _mm_cmple_pd(inner.max_, max_))) ==
               3;
    }
    [[nodiscard]] double area() const {
        const __m128d size = _mm_sub_pd(max_, min_);
        return _mm_cvtsd_f64(_mm_mul_sd(size, _mm_unpackhi_pd(size, size)));
    }
    [[nodiscard]] RectLanes intersection(const RectLanes& other) const {
        return {_mm_max_pd(other.min_, min_), _mm_min_pd(other.max_, max_)};
    }
    [[nodiscard]] RectLanes unionWith(const RectLanes& other) const {
        return {_mm_min_pd(other.min_, min_), _mm_max_pd(other.max_, max_)};
    }

private:
    RectLanes(const __m128d& min, const __m128d& max) : min_(min), max_(max) {}
    __m128d min_, max_; ///< (x, y)
};
#else
#error later
#endif

[[nodiscard]] inline Rect intersection(const Rect& a, const Rect& b) {
    return {std::max(a.minX, b.minX), std::max(a.minY, b.minY), std::min(a.maxX, b.maxX),
            std::min(a.maxY, b.maxY)};
}

} // namespace limen::visibility
