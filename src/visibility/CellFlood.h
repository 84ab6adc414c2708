#pragma once

#include "visibility/FloodTrace.h"
#include "visibility/Graph.h"
#include "visibility/VisibleSet.h"

#include <array>
#include <span>
#include <vector>

namespace limen::visibility {

/// The flood inside one zone: from cell to cell, each with the screen rectangles in which rays enter it. It
/// does not decide the picture (inside a zone depth does). It finds the cells to draw and the portals out of
/// the zone to clip, so a rectangle may be too large, never too small.
///
/// A cell with several rectangles keeps them apart, because their union would include everything between them
/// on the screen. Adjacent rectangles are merged if neither has been followed yet. Beyond kRects the union is
/// used, so that the work stays proportional to the cells seen.
class CellFlood {
public:
    /// The input for one zone.
    struct Input {
        const Graph* graph = nullptr;
        std::span<const std::uint8_t> closed; ///< by portal; empty: all open
        Vec3 eye{0.0};
        Mat3 screenFromEye{1.0};
        std::uint32_t visit = 0; ///< number given to the SeenSpaces
        std::uint32_t entrySpace = 0;
        std::uint32_t entryPortal = kNone;
        Rect entryRect;
        FloodTrace* trace = nullptr; ///< null: no trace
    };

    /// Appends the spaces of the zone that may be seen to `seen`.
    void run(const Input& input, std::vector<SeenSpace>& seen, FloodCounts& counts);

private:
    static constexpr std::uint32_t kRects = 6;
    struct Mark {
        std::uint32_t stamp = 0, slot = 0, count = 0;
        std::array<Rect, kRects> rects;             ///< entered so far
        std::array<std::uint32_t, kRects> arrivals; ///< their positions in the queue
    };
    struct Arrival {
        std::uint32_t space = 0;
        Rect rect;
    };
    void enter(std::uint32_t space, const Rect& rect, std::vector<SeenSpace>& seen, FloodCounts& counts);
    /// Merges the rectangle with one that has not been followed yet; returns whether there was one.
    [[nodiscard]] bool mergeWaiting(Mark& mark, const Rect& rect);
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
