#pragma once

#include "visibility/FloodTrace.h"
#include "visibility/Graph.h"
#include "visibility/VisibleSet.h"

#include <array>
#include <span>
#include <vector>

namespace limen::visibility {

/// The flood inside one zone: from cell to cell, each with rectangles of the screen in which it is reached.
/// It decides nothing about the picture (inside a zone depth does); it finds the cells worth drawing and the
/// portals out of the zone worth clipping. So a rectangle may be too large, never too small. A cell reached
/// in several places keeps the rectangles apart, since their union would let in everything that lies between
/// them on the screen, unless they lie side by side and none has been followed yet; beyond kRects of them it
/// falls back to the union, which bounds the work by the cells seen.
class CellFlood {
public:
    /// What one flood of a zone works on.
    struct Input {
        const Graph* graph = nullptr;
        std::span<const std::uint8_t> closed; ///< by portal; empty: all open
        Vec3 eye{0.0};
        Mat3 screenFromEye{1.0};
        std::uint32_t visit = 0; ///< number given to the SeenSpaces
        std::uint32_t entrySpace = 0;
        std::uint32_t entryPortal = kNone;
        Rect entryRect;
        FloodTrace* trace = nullptr; ///< null: nobody wants to know why
    };

    /// Appends the spaces of the zone that may be seen to `seen`.
    void run(const Input& input, std::vector<SeenSpace>& seen, FloodCounts& counts);

private:
    static constexpr std::uint32_t kRects = 6;
    struct Mark {
        std::uint32_t stamp = 0, slot = 0, count = 0;
        std::array<Rect, kRects> rects;             ///< those let in so far
        std::array<std::uint32_t, kRects> arrivals; ///< and where they are in the queue
    };
    struct Arrival {
        std::uint32_t space = 0;
        Rect rect;
    };
    void reach(std::uint32_t space, const Rect& rect, std::vector<SeenSpace>& seen, FloodCounts& counts);
    /// True if the rectangle has gone into one that waits to be followed.
    [[nodiscard]] bool joinWaiting(Mark& mark, const Rect& rect);
    template <bool kTraced>
    void leave(const Input& input, const Arrival& from, std::vector<SeenSpace>& seen, FloodCounts& counts);
    template <bool kTraced>
    void tryPortal(const Input& input, std::uint32_t portal, const Rect& rect, std::vector<SeenSpace>& seen,
                   FloodCounts& counts);

    std::vector<Mark> marks_; ///< by space
    std::vector<Arrival> queue_;
    std::size_t head_ = 0;
    std::uint32_t stamp_ = 0;
    std::uint32_t visit_ = 0;
    std::vector<Vec3> clipped_, swap_;
    [[nodiscard]] bool screenRect(const Input& input, const Graph::Portal& portal, Rect& rect);
};

} // namespace limen::visibility
