#pragma once

#include "dat/records/Mesh.h"
#include "geometry/Plane.h"
#include "worlds/records/FaceMesh.h"

#include <span>

namespace limen::worlds {

/// The drawing tree of a mesh. Inner nodes list the polygons in their plane. A polygon that another one's
/// plane cuts is listed in both halves. Portal faces become PORT nodes that name (polygon id, portal index),
/// in order of face.
[[nodiscard]] dat::BspTree buildDrawingBsp(std::span<const Face> faces);

/// The physics tree of a mesh: polygons are in the leaves in front of them, solid leaves behind. `ids` names
/// the faces.
[[nodiscard]] dat::BspTree buildPhysicsBsp(std::span<const Face> faces, std::span<const std::uint16_t> ids);

/// The chain "in front of every plane" for a closed cell whose faces look inwards. It is exact for a convex
/// cell. For any other cell it holds the region that those planes enclose that have the whole cell in front
/// of them.
[[nodiscard]] dat::BspTree buildCellBsp(std::span<const Face> faces);

[[nodiscard]] std::uint32_t leafCount(const dat::BspTree& tree);

} // namespace limen::worlds
