#pragma once

#include "world/records/Records.h"
#include "world/terrain/Terrain.h"

#include <set>

namespace limen::world {

/// One object that a Scene record places on the landscape.
struct SceneryObject {
    dat::RecordId model = 0;
    Vec3 origin{0.0}; ///< block-local
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
};

/// True if a block-local position is on a road: within 5 m of the lines between road corners.
/// docs/formats/landscape.md#roads.
[[nodiscard]] bool isOnRoad(const Ground& ground, double x, double y);

/// The scenery of a block, in the order of vertices and scene entries. It depends only on the position on the
/// map and on the records. `builtCells`: landcells (cx*8+cy) that contain a building; nothing grows there.
[[nodiscard]] std::vector<SceneryObject> growScenery(const Ground& ground, const dat::Region& region,
                                                     const std::set<int>& builtCells, Records& records);

} // namespace limen::world
