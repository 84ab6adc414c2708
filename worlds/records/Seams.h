#pragma once

#include "worlds/records/FaceMesh.h"

namespace limen::worlds {

/// Metres. Floats hold every point of this grid within 1 km exactly. Walls at right angles are flat on any
/// grid.
inline constexpr double kBuiltGrid = 1.0 / 8192.0;
/// The finest grid (metres, a power of two) on which floats hold every point of these faces. Walls at odd
/// angles are flat to one step of it. With coarser steps, say 0.1 mm, zones and openings are distinguished
/// less well (docs/cases.md).
[[nodiscard]] double finestGrid(const std::vector<Face>& faces);

/// Rounds points to multiples of `grid` metres, then adds to every face the vertices of other faces that are
/// on its edges. Afterwards edges match one to one, without cracks or T-junctions.
void closeSeams(std::vector<Face>& faces, double grid = kBuiltGrid);

/// Rounds points to multiples of `grid` metres. Faces stay joined as they are, and become bent. Corners that fall on one
/// point become one; a face that has fewer than three then is removed.
void roundCorners(std::vector<Face>& faces, double grid);

/// Closes seams between meshes that meet at openings: all get the vertices that one of them has on the border
/// of a portal face. Requires: each mesh's own seams are closed on kBuiltGrid.
void closePortalSeams(const std::vector<std::vector<Face>*>& meshes);

} // namespace limen::worlds
