#pragma once

#include "visibility/Graph.h"
#include "visibility/View.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::bench {

/// A graph, and the views from which a benchmark floods it.
struct FloodScene {
    std::string name;
    visibility::Graph graph;
    std::vector<visibility::View> views;
};

/// A grid of square rooms, 10 m wide and 4 m high. Each shared wall has a door in its middle, 3 m high and
/// `door` metres wide. All rooms are one zone, because the loader merges closed, disjoint cells. Views: 1,000
/// random eyes and directions, 90 by 60 degrees.
[[nodiscard]] FloodScene roomGrid(int columns, int rows, double door, std::uint32_t seed);

/// The same grid with a zone for each room. It shows the cost of the exact tree of visits if no cells can be
/// merged.
[[nodiscard]] FloodScene roomGridApart(int columns, int rows, double door, std::uint32_t seed);

} // namespace limen::bench
