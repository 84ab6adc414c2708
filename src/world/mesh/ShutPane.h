#pragma once

#include "world/mesh/BakedGeometry.h"
#include "world/mesh/PolygonMesher.h"

#include <span>

namespace limen::world {

/// A part's mesh in its place, in the space that `placement` transforms into; `outline` is in that space,
/// too. Corners within kWeldTolerance of a corner of `outline` are moved onto it. So a shut pane shares its
/// edges with the walls around its opening, to the bit, and no ray hits both or neither.
[[nodiscard]] MeshData placedBetween(std::span<const Vec3> outline, const MeshData& part,
                                     const Placement& placement);

} // namespace limen::world
