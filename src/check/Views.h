#pragma once

#include "check/View.h"
#include "reference/Scene.h"
#include "world/Places.h"

#include <cstddef>
#include <span>
#include <vector>

// Where views come from. Every function appends at most `count` views of one landblock to `out`, fewer where no legal
// eye is found, and gives the same ones for the same surroundings: they follow from the seed alone. All views of a
// block are such that `limen shot` loads the same part of the world for them.
namespace limen::check {

/// A block in its loaded world.
struct Surroundings {
    const world::World& world;
    const reference::Scene& scene; ///< of the same world: says what is in an eye's way
    dat::BlockCoord block;
    std::uint64_t seed = 1;
    std::uint32_t width = 640, height = 360; ///< pixels
    std::span<const world::Place> tour{};    ///< way points, in order
};

/// Eyes anywhere in the block's cells, every cell in turn, looking anywhere. `kind` is Random or Still.
void addRandomViews(const Surroundings& around, Kind kind, std::size_t count, std::vector<View>& out);

/// Eyes above the block's ground, 0.3 to 20 m high, most of them near its openings, half of those looking there.
void addOutsideViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

/// Those of `count` points spread evenly along the whole tour that lie in the block; roots are swept from the last way
/// point on. A point that a straight line from there reaches only through a wall is left out.
void addTourViews(const Surroundings& around, std::size_t count, std::vector<View>& out);
/// How many points of the tour lie in a block, legal or not.
[[nodiscard]] std::size_t tourPointsIn(std::span<const world::Place> tour, std::size_t count,
                                       dat::BlockCoord block);

/// Walks in steps of 1 cm up to an opening, through it, and on to the next.
void addWalkViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

/// Eyes on lines through every opening of the block's cells: square through its middle, aslant, 4 to 60 mm beside an edge and
/// a corner, and along an edge and a corner; 1 mm apart within 2 cm of its plane, 1 cm apart out to 30 cm, and at
/// distances around the 0.2 mm of the tolerance; from both sides; looking along, against, sideways, at grazing angles
/// and anyhow. `count` of all those combinations, spread evenly over them.
void addSweepViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

} // namespace limen::check
