#pragma once

#include "placements/Placements.h"
#include "world/Places.h"

namespace limen::engine {

/// Entries of a world.json as rows of a world database.
struct WorldFileRows {
    placements::Content content;
    std::size_t doors = 0, people = 0; ///< that have rows
    std::size_t left = 0;              ///< doors, panes, villagers and emitters that rows cannot hold
};

/// The doors whose leaves name motion tables, and the villagers, as rows. A leaf becomes a placed object; its template has
/// the door's name. A villager becomes a creature that stands at its start and wears its clothes. Rows hold no routes, no
/// panes, no emitters, no openness between shut and open, and one shade for each garment.
[[nodiscard]] WorldFileRows rowsOf(const world::WorldFile& file);

} // namespace limen::engine
