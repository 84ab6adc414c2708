#pragma once

#include "visibility/FloodTrace.h"
#include "visibility/RectLanes.h"
#include "visibility/ScreenOpenings.h"
#include "visibility/VisibleSet.h"

#include <array>
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
        std::uint32_t visit = 0; ///< number given to the SeenSpaces
        std::uint32_t entrySpace = 0;
        Rect entryRect;
        FloodTrace* trace = nullptr; ///< null: no trace
    };

    /// Appends the spaces of the zone that may be seen to `seen`.
    void run(const Input& input, const Graph& graph, ScreenOpenings& openings, std::vector<SeenSpace>& seen,
             FloodCounts& counts);

private:
    static constexpr std::uint32_t kRects = 6;
    /// The number that a space has in this run, if the stamp is that of the run.
    struct Mark {
        std::uint32_t stamp = 0, cell = 0;
    };
    /// A space that has been entered.
    struct Cell {
        std::uint32_t count = 0;
        std::array<std::uint32_t, kRects> arrivals; ///< their positions in the queue, in ascending order
        std::array<Rect, kRects> rects;             ///< entered so far
    };
    struct Arrival {
        std::uint32_t space = 0;
        Rect rect;
    };
    template <bool kTraced>
    void follow(const Input& input, ScreenOpenings& openings, std::vector<SeenSpace>& seen,
                FloodCounts& counts);
    void push(std::uint32_t space, const Rect& rect);
    void enter(std::uint32_t space, const RectLanes& rect, std::vector<SeenSpace>& seen, FloodCounts& counts);
    void enterFirst(std::uint32_t space, const RectLanes& rect, std::vector<SeenSpace>& seen);
    /// Merges the rectangle with one that has not been followed yet; returns whether there was one.
    [[nodiscard]] bool mergeWaiting(Cell& cell, const RectLanes& rect);

    std::vector<Mark> marks_;    ///< by space
    std::vector<Cell> cells_;    ///< by SeenSpace of the run; never shrinks
    std::vector<Arrival> queue_; ///< never shrinks
    std::size_t head_ = 0, tail_ = 0;
    std::size_t firstSeen_ = 0;
    std::uint32_t stamp_ = 0;
    std::uint32_t visit_ = 0;
};

} // namespace limen::visibility
