#pragma once

#include "geometry/Vec.h"

#include <optional>
#include <span>
#include <vector>

namespace limen::world {

/// The parts of two outlines in about one plane, the sides of one opening. Each part is a simple polygon,
/// counter-clockwise seen from the tip of the normal.
struct OpeningOverlay {
    using Loop = std::vector<Vec3>;
    std::vector<Loop> common;        ///< inside both
    std::vector<Loop> first, second; ///< inside one only
};

/// Cuts two outlines where they cross, seen along `normal` (a unit vector); both are counter-clockwise from its tip. All
/// edges of an outline, cut at vertices of the parts, are edges of its parts: common and own ones. The vertices of the outlines are
/// kept to the bit. Two edges that cross on the plane may pass each other in space, by a gap. Then each gets a vertex,
/// half the gap inside the other outline, and an edge joins the two. nullopt: there is no common part, or the
/// outlines are not simple polygons.
[[nodiscard]] std::optional<OpeningOverlay> overlayOpenings(std::span<const Vec3> first,
                                                            std::span<const Vec3> second, const Vec3& normal);

} // namespace limen::world
