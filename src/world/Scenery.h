#pragma once

#include "world/Records.h"
#include "world/Terrain.h"

#include <set>

namespace limen::world {

/// An object that grows on the landscape.
struct SceneryObject {
    dat::RecordId model = 0;
    Vec3 origin{0.0}; ///< block-local
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
};

/// True if a block-local position lies on a road (docs/formats/landscape.md#roads): within 5 m of the lines between
/// road corners.
[[nodiscard]] bool isOnRoad(const Ground& ground, double x, double y);

/// The scenery of a block, in the order of vertices and scene entries: a function of position on the map and
/// of the records alone. `builtCells`: landcells (cx*8+cy) that hold a building.
[[nodiscard]] std::vector<SceneryObject> growScenery(const Ground& ground, const dat::Region& region,
                                                     const std::set<int>& builtCells, Records& records);

} // namespace limen::world
