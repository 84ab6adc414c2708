#pragma once

#include "dat/Ids.h"
#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/builtin/places/Eye.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace limen::worlds {

/// The placements of the village's buildings (coordinates of the village block), their cells, and the lists
/// of doors and people in the form of `world.json` (docs/world-file.md).
struct VillageMap {
    Placement cottage, neighbour, inn, hall;
    std::vector<dat::RecordId> cottageCells, neighbourCells, innCells, hallCells;
    nlohmann::ordered_json doors, routes, villagers, player;
    Furniture furniture; ///< models that other parts of the world reuse
};

/// A point of a building of the village, in global metres.
[[nodiscard]] Vec3 globalOf(const Placement& building, const Vec3& local);

struct DungeonMap;
/// `world.json`: place names, the tour, emitters, and the map's lists of doors and people.
[[nodiscard]] nlohmann::ordered_json buildWorldFile(const VillageMap& map, const DungeonMap& dungeons);

} // namespace limen::worlds
