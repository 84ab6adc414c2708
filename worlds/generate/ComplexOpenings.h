#pragma once

#include "worlds/generate/Random.h"
#include "worlds/shapes/Carve.h"

namespace limen::worlds {

/// What a complex favours; a seed's character.
struct OpeningMix {
    double slivers = 0.06; ///< openings 1 cm wide
    double twins = 0.12;   ///< two openings that share an edge
    double inexact = 0.0;  ///< pairs that differ by some centimetres
    double reversed = 0.0; ///< polygons wound the other way, with the flag to match
    bool toGround = false; ///< land around it, and ways out
};

/// One opening as each of its two cells has it, both wound alike.
struct OpeningPair {
    Polygon first, second;
    bool exact = true;
};

/// One or two openings in a shared face: round with 3 to 12 corners, cut from it so that they share edges with it,
/// all of it, 1 cm wide, or two side by side. `walls` are the two cells' sides that the face is part of: what shares
/// edges with the face has corners on theirs or clear of them.
[[nodiscard]] std::vector<OpeningPair> makeOpenings(const Polygon& face, std::span<const Polygon> walls,
                                                    const OpeningMix& mix, Random& random);

/// A convex polygon with 3 to 12 corners inside a face, clear of its edges.
[[nodiscard]] Polygon roundOpening(const Polygon& face, Random& random);

} // namespace limen::worlds
