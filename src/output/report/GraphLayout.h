#pragma once

#include "geometry/Vec.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace limen::output {

/// Moves the nodes of a graph apart: joined nodes end about one unit apart, others farther. `start` has the
/// initial positions, at any scale; nodes that were east of others tend to stay there. The result is
/// centred at (0, 0), and no two nodes have the same position. The same input gives the same result.
/// Requires edges between nodes of `start`. Time grows linearly with nodes and edges.
[[nodiscard]] std::vector<Vec2> layOutGraph(std::span<const Vec2> start,
                                            std::span<const std::pair<std::uint32_t, std::uint32_t>> edges);

} // namespace limen::output
