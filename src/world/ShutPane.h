#pragma once

#include "world/BakedGeometry.h"
#include "world/MeshBuilder.h"

#include <span>

namespace limen::world {

/// A part's mesh where it stands, to be drawn as it is. Corners within kWeldTolerance of one of `outline` become that: a shut pane
/// shares its edges with the walls around its opening, to the bit, so that no ray finds both or neither. Both in the space
/// that `placement` leads to.
[[nodiscard]] MeshData placedBetween(std::span<const Vec3> outline, const MeshData& part,
                                     const Placement& placement);

} // namespace limen::world
