#pragma once

#include "dat/Ids.h"
#include "demo/Furniture.h"

#include <nlohmann/json.hpp>
#include <string>

namespace limen::demo {

/// A standing eye: global metres, degrees; `cell` 0 means outside.
struct Eye {
    Vec3 position{0.0};
    double yaw = 0.0, pitch = 0.0;
    dat::RecordId cell = 0;
};

/// What the places are measured from: where the buildings stand (coordinates of the village block) and their
/// cells.
struct VillageMap {
    Placement cottage, neighbour;
    std::vector<dat::RecordId> cottageCells, neighbourCells;
    Furniture furniture; ///< models, for whoever furnishes more
};

/// Turns the eye towards a global point.
void lookAt(Eye& eye, const Vec3& target);

struct DungeonMap;
/// `world.json`: place names, the tour, emitters, and empty lists for what moves (filled by later versions).
[[nodiscard]] nlohmann::ordered_json buildWorldFile(const VillageMap& map, const DungeonMap& dungeons);

} // namespace limen::demo
