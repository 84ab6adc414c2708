#pragma once

#include "visibility/Graph.h"
#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

namespace limen::visibility {

/// The flood inside one zone: from cell to cell, each with one rectangle that only grows. It decides nothing
/// about the picture (inside a zone depth does); it finds the cells worth drawing and the portals out of the
/// zone worth clipping. So a rectangle may be too large, never too small.
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
    };

    /// Appends the spaces of the zone that may be seen to `seen`.
    void run(const Input& input, std::vector<SeenSpace>& seen, FloodCounts& counts);

private:
    struct Mark {
        std::uint32_t stamp = 0, slot = 0;
        bool queued = false;
    };
    void reach(std::uint32_t space, const Rect& rect, std::vector<SeenSpace>& seen, FloodCounts& counts);
    void leave(const Input& input, std::uint32_t slot, std::vector<SeenSpace>& seen, FloodCounts& counts);
    void tryPortal(const Input& input, std::uint32_t portal, const Rect& rect, std::vector<SeenSpace>& seen,
                   FloodCounts& counts);

    std::vector<Mark> marks_; ///< by space
    std::vector<std::uint32_t> queue_;
    std::size_t head_ = 0;
    std::uint32_t stamp_ = 0;
    std::uint32_t visit_ = 0;
    std::vector<Vec3> clipped_, swap_;
    [[nodiscard]] bool screenRect(const Input& input, const Graph::Portal& portal, Rect& rect);
};

} // namespace limen::visibility
