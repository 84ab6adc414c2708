#pragma once

#include "worlds/records/FaceMesh.h"

namespace limen::worlds {

/// A cell tree for any closed shell whose faces look inwards: in front of a node's plane is the positive
/// child, behind it the negative one; a missing negative child is outside. A convex shell gives one chain of
/// positive children. Else the chain is a convex part that holds `middle`. Requires: the shell's own planes
/// bound such a part.
[[nodiscard]] dat::BspTree buildSolidCellBsp(const std::vector<Face>& faces, const Vec3& middle);

} // namespace limen::worlds
