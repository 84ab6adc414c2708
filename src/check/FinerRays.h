#pragma once

#include "geometry/Tolerances.h"
#include "reference/Scene.h"

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

// Second looks at a pixel: rays between the traced ones. Distances are in pixels. `trace(x, y)` returns the
// reference::Answer of a ray; `test` accepts the answers that explain the pixel.
namespace limen::check {

/// Spacing of the finest grid in pixels, and its rays on either side of the middle. It covers kSnapTolerance
/// each way.
inline constexpr double kFinest = 1.0 / 2048.0;
inline constexpr int kFinestReach = 16;
static_assert(kFinest * kFinestReach == kSnapTolerance);
/// Halvings of kFinest until two rays are 1e-13 of a pixel apart, near the resolution of doubles.
inline constexpr int kHalvings = 32;
/// The most rays between two neighbours of the finest grid: enough for thirty boundaries of surfaces.
inline constexpr int kMostBetween = 1024;

/// True if any of (2·reach + 1)² rays, `step` apart around the centre of a pixel, passes the test.
template <class Trace, class Test>
[[nodiscard]] bool anyFiner(int x, int y, double step, int reach, Trace trace, Test test) {
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx)
            if (test(trace(x + dx * step, y + dy * step)))
                return true;
    }
    return false;
}

[[nodiscard]] inline bool isSameAnswer(const reference::Answer& a, const reference::Answer& b) {
    return a.id == b.id && a.layers == b.layers;
}

/// The finest grid around the centre of a pixel, traced.
class FinestGrid {
public:
    template <class Trace>
    FinestGrid(int x, int y, Trace trace) : x_(x), y_(y) {
        answers_.reserve(kSide * kSide);
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i)
                answers_.push_back(trace(placeOf(i, j).x, placeOf(i, j).y));
    }

    template <class Test>
    [[nodiscard]] bool any(Test test) const {
        return std::any_of(answers_.begin(), answers_.end(), test);
    }

    /// True if a ray on a boundary of two surfaces passes the test, between any two neighbours of the grid.
    template <class Trace, class Test>
    [[nodiscard]] bool anyOnBoundaries(Trace trace, Test test) const {
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i)
                if ((i + 1 < kSide && anyBetween({i, j}, {i + 1, j}, trace, test)) ||
                    (j + 1 < kSide && anyBetween({i, j}, {i, j + 1}, trace, test)))
                    return true;
        }
        return false;
    }

private:
    static constexpr int kSide = 2 * kFinestReach + 1;

    [[nodiscard]] glm::dvec2 placeOf(int i, int j) const {
        return {x_ + (i - kFinestReach) * kFinest, y_ + (j - kFinestReach) * kFinest};
    }
    [[nodiscard]] const reference::Answer& at(glm::ivec2 p) const {
        return answers_[static_cast<std::size_t>(p.y * kSide + p.x)];
    }

    /// True if a ray between two neighbours passes the test, found by halving towards boundaries of surfaces.
    /// Strips between surfaces may be narrower than any grid, and several may be side by side: the tops of
    /// planks at eye level.
    template <class Trace, class Test>
    [[nodiscard]] bool anyBetween(glm::ivec2 first, glm::ivec2 second, Trace trace, Test test) const {
        int rays = kMostBetween;
        const auto search = [&](const auto& self, const End& a, const End& b, int halvings) -> bool {
            if (halvings == 0 || rays == 0 || isSameAnswer(a.answer, b.answer))
                return false;
            --rays;
            const glm::dvec2 place = (a.place + b.place) * 0.5;
            const End middle{place, trace(place.x, place.y)};
            return test(middle.answer) || self(self, a, middle, halvings - 1) ||
                   self(self, middle, b, halvings - 1);
        };
        return search(search, {placeOf(first.x, first.y), at(first)},
                      {placeOf(second.x, second.y), at(second)}, kHalvings);
    }
    struct End {
        glm::dvec2 place{0.0};
        reference::Answer answer;
    };

    int x_, y_;
    std::vector<reference::Answer> answers_;
};

/// True if a ray within the 3×3 pixels passes the test. Searches around the middle, then wider, then over all
/// nine pixels, and last along boundaries.
template <class Trace, class Test>
[[nodiscard]] bool onFinerRays(int x, int y, Trace trace, Test test) {
    const FinestGrid finest(x, y, trace);
    return finest.any(test) || anyFiner(x, y, 1.0 / 64.0, 8, trace, test) ||
           anyFiner(x, y, 1.0 / 16.0, 24, trace, test) || finest.anyOnBoundaries(trace, test);
}

} // namespace limen::check
