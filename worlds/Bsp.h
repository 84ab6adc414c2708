#pragma once

#include "dat/records/Mesh.h"
#include "geometry/Plane.h"
#include "worlds/Mesh.h"

#include <span>

namespace limen::worlds {

/// A drawing tree over a mesh: inner nodes list the polygons in their plane; polygons that others' planes cut
/// are listed in both halves. Faces marked as portals become PORT nodes that name (polygon id, portal index)
/// in order of face.
[[nodiscard]] dat::BspTree buildDrawingBsp(std::span<const Face> faces);

/// A physics tree: polygons in the leaves in front of them, solid leaves behind. `ids` names the faces.
[[nodiscard]] dat::BspTree buildPhysicsBsp(std::span<const Face> faces, std::span<const std::uint16_t> ids);

/// The chain "in front of every plane" for a closed cell whose faces look inwards: the cell itself if it is convex,
/// else what the planes with the whole cell in front of them enclose.
[[nodiscard]] dat::BspTree buildCellBsp(std::span<const Face> faces);

[[nodiscard]] std::uint32_t leafCount(const dat::BspTree& tree);

} // namespace limen::worlds
