#pragma once

#include "check/View.h"
#include "reference/Scene.h"
#include "world/Places.h"

#include <cstddef>
#include <span>
#include <vector>

// Generators of views. Every function appends at most `count` views of one landblock to `out`, fewer where it
// finds no legal viewpoint. Equal surroundings give equal views: they depend on the seed alone. For every
// view of a block, `limen shot` loads the same part of the world.
namespace limen::check {

/// A block in its loaded world.
struct Surroundings {
    const world::World& world;
    const reference::Scene& scene; ///< of the same world; finds obstacles
    dat::BlockCoord block;
    std::uint64_t seed = 1;
    std::uint32_t width = 640, height = 360; ///< pixels
    std::span<const world::Place> tour{};    ///< way points, in order
};

/// Random viewpoints in the block's cells, each cell in turn, with random gazes. `kind` is Random or Still.
void addRandomViews(const Surroundings& around, ViewKind kind, std::size_t count, std::vector<View>& out);

/// Viewpoints 0.3 to 20 m above the block's ground, most of them near openings, half of those with a gaze
/// towards one.
void addOutsideViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

/// The points in the block, of `count` points spread evenly along the whole tour. The root is found by a
/// sweep from the last way point. A point behind a wall, seen from there, is left out.
void addTourViews(const Surroundings& around, std::size_t count, std::vector<View>& out);
/// The number of the tour's points in a block, legal or not.
[[nodiscard]] std::size_t tourPointsIn(std::span<const world::Place> tour, std::size_t count,
                                       dat::BlockCoord block);

/// Walks in steps of 1 cm up to an opening, through it, and to the next one.
void addWalkViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

/// Viewpoints on lines through every opening of the block's cells; `count` of all combinations, spread
/// evenly. Lines: square through the middle, slanting, 4 to 60 mm beside an edge and a corner, and through an
/// edge and a corner; from both sides. Distances from the plane: 1 mm apart within 2 cm, 1 cm apart up to 30
/// cm, and around kInPlaneTolerance. Gazes: along, against, sideways, at grazing angles and random.
void addSweepViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

/// Viewpoints at openings: 1 micrometre to 1 cm off the plane, on either side, anywhere inside or as far off an edge or
/// a corner. Up to kInPlaneTolerance off the plane, half of the eyes are said to be on the other side. Gazes: along the
/// plane, up to 0.3 rad off it, and random.
void addStraddleViews(const Surroundings& around, std::size_t count, std::vector<View>& out);

/// Random viewpoints with extreme fields of view. Telephoto: 2 to 10 degrees, towards an opening of the cell or one
/// behind it. Wide: 150 to 170 degrees.
void addLensViews(const Surroundings& around, ViewKind kind, std::size_t count, std::vector<View>& out);

} // namespace limen::check
