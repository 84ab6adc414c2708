#pragma once

#include "visibility/Rect.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace limen::visibility {

#ifdef __SSE2__
/// A rectangle in vector registers. No operation branches, because most outcomes are unpredictable.
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
class RectLanes {
public:
    RectLanes(const Rect& rect) : rect_(rect) {}
    [[nodiscard]] Rect rect() const { return rect_; }
    [[nodiscard]] bool empty() const { return rect_.empty(); }
    [[nodiscard]] bool contains(const RectLanes& inner) const {
        return inner.rect_.minX >= rect_.minX && inner.rect_.maxX <= rect_.maxX &&
               inner.rect_.minY >= rect_.minY && inner.rect_.maxY <= rect_.maxY;
    }
    [[nodiscard]] double area() const { return (rect_.maxX - rect_.minX) * (rect_.maxY - rect_.minY); }
    [[nodiscard]] RectLanes intersection(const RectLanes& other) const {
        return visibility::intersection(rect_, other.rect_);
    }
    [[nodiscard]] RectLanes unionWith(const RectLanes& other) const {
        Rect both = rect_;
        both.include(other.rect_.minX, other.rect_.minY);
        both.include(other.rect_.maxX, other.rect_.maxY);
        return both;
    }

private:
    Rect rect_;
};
#endif

} // namespace limen::visibility
