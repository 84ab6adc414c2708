#pragma once

#include "visibility/Graph.h"
#include "visibility/View.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::bench {

/// A graph and the views that a benchmark floods it from.
struct FloodScene {
    std::string name;
    visibility::Graph graph;
    std::vector<visibility::View> views;
};

/// A grid of square rooms 10 m wide and 4 m high, a door 3 m high and `door` metres wide in the middle of
/// every shared wall, all rooms one zone: closed, disjoint cells, as the loader would merge them. Views:
/// 1,000 random eyes and directions, 90 by 60 degrees.
[[nodiscard]] FloodScene roomGrid(int columns, int rows, double door, std::uint32_t seed);

/// The same with every room a zone of its own: what the exact tree of visits costs where nothing can be
/// merged.
[[nodiscard]] FloodScene roomGridApart(int columns, int rows, double door, std::uint32_t seed);

} // namespace limen::bench
