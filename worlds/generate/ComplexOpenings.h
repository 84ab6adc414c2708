#pragma once

#include "worlds/records/Carve.h"
#include "worlds/shapes/Random.h"

namespace limen::worlds {

/// Probabilities of the kinds of openings in a complex; they depend on the seed.
struct OpeningMix {
    double slivers = 0.06; ///< openings 1 cm wide
    double twins = 0.12;   ///< two openings that share an edge
    double inexact = 0.0;  ///< pairs that differ by some centimetres
    double reversed = 0.0; ///< polygons with the opposite winding, and the flag to match
    bool toGround = false; ///< with land around it, and exits
};

/// One opening as a polygon of each of its two cells, with the same winding.
struct OpeningPair {
    Polygon first, second;
    bool exact = true;
};

/// One or two openings in a shared face: round with 3 to 12 corners; cut from the face, with which they share
/// edges; the whole face; 1 cm wide; or two side by side. `walls`: the two cells' sides that contain the
/// face. An opening that shares edges with the face has its corners on the walls' edges or clear of them.
[[nodiscard]] std::vector<OpeningPair> makeOpenings(const Polygon& face, std::span<const Polygon> walls,
                                                    const OpeningMix& mix, Random& random);

/// A convex polygon with 3 to 12 corners inside a face, clear of its edges.
[[nodiscard]] Polygon roundOpening(const Polygon& face, Random& random);

} // namespace limen::worlds
