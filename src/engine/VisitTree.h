#pragma once

#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <string>
#include <vector>

namespace limen::engine {

/// Why a space is drawn, in a line: the visit's number, what it leads into, through which portal of which space, and the share of
/// the window that its region takes; of a hole, why the rays end there.
[[nodiscard]] std::string visitLabel(const world::World& world, const visibility::VisibleSet& visible,
                                     std::uint32_t visit);

/// The spaces seen in a visit besides the one it leads into: of its zone, where depth alone decides. Names, in the order of the
/// flood.
[[nodiscard]] std::vector<std::string>
seenBesides(const world::World& world, const visibility::VisibleSet& visible, std::uint32_t visit);

} // namespace limen::engine
