#pragma once

#include "visibility/Graph.h"
#include "visibility/View.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// The classic portal flood of 1990s engines, for comparison with visibility/Flood.h. It follows all paths
/// through portals, and clips each opening by the planes through the eye and the edges of the opening before.
/// A search of the path breaks cycles. It marks spaces only: it has no exact regions, no order and no zones.
class PathFlood {
public:
    /// Marks the spaces seen. Returns the number of portals admitted, over all paths.
    std::uint32_t run(const visibility::Graph& graph, const visibility::View& view);
    [[nodiscard]] const std::vector<std::uint8_t>& seen() const { return seen_; }

private:
    struct Step {
        const Step* previous = nullptr;
        std::uint32_t portal = 0;
    };
    void enter(std::uint32_t space, const Step* path, const std::vector<Plane>& planes);

    const visibility::Graph* graph_ = nullptr;
    Vec3 eye_{0.0};
    std::uint32_t admitted_ = 0;
    std::vector<std::uint8_t> seen_;
};

} // namespace limen::bench
