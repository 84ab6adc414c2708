#pragma once

#include "dat/Ids.h"
#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/builtin/places/Eye.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace limen::worlds {

/// What the places are measured from: where the buildings stand (coordinates of the village block) and their
/// cells. The lists of what moves are as `world.json` has them (docs/world-file.md).
struct VillageMap {
    Placement cottage, neighbour, inn, hall;
    std::vector<dat::RecordId> cottageCells, neighbourCells, innCells, hallCells;
    nlohmann::ordered_json doors, routes, villagers, player;
    Furniture furniture; ///< models, for whoever furnishes more
};

/// A point of a building of the village, in global metres.
[[nodiscard]] Vec3 globalOf(const Placement& building, const Vec3& local);

struct DungeonMap;
/// `world.json`: place names, the tour, what burns and smokes, and the map's lists of what moves.
[[nodiscard]] nlohmann::ordered_json buildWorldFile(const VillageMap& map, const DungeonMap& dungeons);

} // namespace limen::worlds
