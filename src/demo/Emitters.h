#pragma once

#include "demo/DungeonBlocks.h"
#include "demo/Places.h"

namespace limen::demo {

/// The emitters of `world.json`: smoke, fires, torches, fireflies, a swirl in the open, the watchman's lantern,
/// braziers in and before the cave.
[[nodiscard]] nlohmann::ordered_json buildEmitters(const VillageMap& map, const DungeonMap& dungeons);

} // namespace limen::demo
