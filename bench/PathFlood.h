#pragma once

#include "visibility/Graph.h"
#include "visibility/View.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// The plain portal flood that visibility/Flood.h is measured against: it walks every path through portals,
/// clipping each opening by the planes through the eye and the edges of the one before (the classic of 1990s
/// engines). Loops are broken by searching the path. It marks spaces and yields no exact regions, no order
/// and no zones.
class PathFlood {
public:
    /// The spaces seen, each as often as a path reaches it. Returns the number of portals admitted.
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
