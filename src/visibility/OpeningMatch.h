#pragma once

#include "geometry/Plane.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limen::visibility {

/// How two polygons fit together as the two sides of one opening.
struct OpeningMatch {
    enum class Kind : std::uint8_t {
        None,    ///< they are not in one plane, face the same side, or only touch
        Overlap, ///< an inexact pair
        Same     ///< the same corners, in opposite order
    };
    Kind kind = Kind::None;
    double area = 0.0; ///< of the overlap, square metres
};

/// Compares flat, convex polygons. `tolerance`: metres between corners that are one corner, and between planes that
/// are one plane. A strip along a common edge that is no wider than the tolerance is no overlap.
[[nodiscard]] OpeningMatch matchOpenings(std::span<const Vec3> a, std::span<const Vec3> b, double tolerance);

/// True if all of `polygon` is within `inPlane` metres of the plane of an opening, and overlaps it by a strip wider than
/// `overlap` metres. The opening is convex; the polygon need not be.
[[nodiscard]] bool overlapsInPlane(std::span<const Vec3> polygon, std::span<const Vec3> opening,
                                   const Plane& plane, double inPlane, double overlap);

/// Two polygons, by number, that may be the sides of one opening.
struct PairProposal {
    OpeningMatch match;
    std::uint32_t a = 0, b = 0;
};

/// Equal polygons first, then the largest overlap, then by number.
void sortBestFirst(std::vector<PairProposal>& proposals);

} // namespace limen::visibility
