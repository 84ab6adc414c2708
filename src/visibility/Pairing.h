#pragma once

#include "visibility/Graph.h"

#include <cstdint>
#include <span>

namespace limen::visibility {

/// Metres between corners of two portals that are one corner of the opening.
inline constexpr double kPairTolerance = 0.01;

/// The portals that have been paired, and those that remain one-way.
struct Pairing {
    std::uint32_t exact = 0;   ///< pairs with the same polygon
    std::uint32_t inexact = 0; ///< pairs with overlapping polygons: open where both are
    std::uint32_t single = 0;  ///< portals with a destination from which no portal leads back
};

/// Finds the reciprocal of each portal that has none, among those that lead from its destination to its space, face
/// it and are in its plane; sets `reciprocal` and `exact` of both. Equal polygons are paired first, then those that
/// overlap most. `tolerance`: metres. Cost: the square of the number of portals between two spaces. Errors:
/// BadArgument, without a change, for vertices outside the array and for a tolerance that is negative or not finite.
[[nodiscard]] LIMEN_API Result<Pairing> pairReciprocals(std::span<PortalDesc> portals,
                                                        std::span<const Vec3> vertices,
                                                        double tolerance = kPairTolerance);

} // namespace limen::visibility
