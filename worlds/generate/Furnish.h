#pragma once

#include "worlds/generate/DungeonLayout.h"
#include "worlds/generate/Props.h"
#include "worlds/records/CellPlan.h"
#include "worlds/shapes/RoomPlan.h"

#include <span>

namespace limen::worlds {

/// A generator with numbers of its own. The given one is not changed, so that equal seeds give equal layouts, furnished or not.
[[nodiscard]] inline Random apartFrom(Random random) {
    constexpr std::uint64_t kOfFurniture = 0x6675726E;
    return Random(random.next() ^ kOfFurniture << 32);
}

/// The use of a room of a house.
enum class RoomUse : std::uint8_t { Living, Sleeping, Storing };

/// Adds furniture along the walls and a lantern below the ceiling of a box-shaped room. It is clear of doors, hatches, windows
/// and of the corner (min.x, min.y), where another prop can stand. Requires: props.furnished.
void furnishRoom(std::vector<Furnishing>& statics, const RoomSpec& room, std::span<const Opening> openings,
                 RoomUse use, const Props& props, Random random);

/// Adds a light in a dungeon's room, and torches and stores in its corners. Coordinates of the room, with
/// the origin in the middle of the floor. Requires: props.furnished.
void furnishRoom(std::vector<Furnishing>& statics, const LatticeRoom& room, const Props& props,
                 Random random);

/// Adds torches on the walls of a passage that rises by `rise` metres. Coordinates of the passage (passageShell). Requires:
/// props.furnished; a passage to the east or north.
void furnishPassage(std::vector<Furnishing>& statics, const Passage& passage, double rise,
                    const Props& props);

} // namespace limen::worlds
