#pragma once

#include "worlds/builtin/dungeon/DungeonBlocks.h"
#include "worlds/builtin/places/Places.h"

namespace limen::worlds {

/// The emitters of `world.json`: smoke, fires, torches, fireflies, an outdoor swirl, the watchman's lantern,
/// braziers in and before the cave.
[[nodiscard]] nlohmann::ordered_json buildEmitters(const VillageMap& map, const DungeonMap& dungeons);

} // namespace limen::worlds
