#pragma once

#include "world/block/BlockContent.h"

namespace limen::world {

/// Cuts each opening that is not flat into triangles, each a portal of its own (docs/ray-rule.md). Such an opening has
/// a vertex that is off its plane or its convex hull by more than the rounding of the records. Both portals of an exact
/// pair are cut along the same diagonals, so the cells stay closed; an opening of one way is cut alone. The parts take
/// the place of the portal; indices of portals change. Called after finishBuildings.
void splitBentOpenings(BlockContent& block);

} // namespace limen::world
