#pragma once

#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <string>
#include <vector>

namespace limen::engine {

/// One line that explains why a space is drawn: number of the visit, its space, the portal and that portal's
/// space, and the region's share of the picture. For a hole it gives the reason why the rays end. Requires a
/// visit of `visible`.
[[nodiscard]] std::string visitLabel(const world::World& world, const visibility::VisibleSet& visible,
                                     std::uint32_t visit);

/// Names of the other spaces that a visit sees, in the order of the flood. They are in the zone of the visit,
/// so no portal separates them: depth alone decides. Requires a visit of `visible`.
[[nodiscard]] std::vector<std::string>
seenBesides(const world::World& world, const visibility::VisibleSet& visible, std::uint32_t visit);

} // namespace limen::engine
