#pragma once

#include "worlds/builtin/dungeon/DungeonBlocks.h"
#include "worlds/builtin/places/Eye.h"
#include "worlds/builtin/places/Tour.h"

#include <string>

namespace limen::worlds {

/// Places of tower, cave and dungeons, in the order of their names in `world.json`.
[[nodiscard]] std::vector<std::pair<std::string, Eye>> dungeonPlaces(const DungeonMap& map);
/// The part of the tour from the lane up to the tower and its roof, to the cave, down to the hub and the pit.
[[nodiscard]] std::vector<TourLeg> dungeonTour(const DungeonMap& map);
/// A fire in a bowl: the origin of its sparks, global metres; `cell` 0 means outside.
struct Fire {
    std::string name;
    Vec3 position{0.0};
    dat::RecordId cell = 0;
};
[[nodiscard]] std::vector<Fire> brazierFires(const DungeonMap& map);

} // namespace limen::worlds
