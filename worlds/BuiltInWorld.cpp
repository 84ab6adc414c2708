#include "worlds/BuiltInWorld.h"

#include "worlds/builtin/dungeon/DungeonBlocks.h"
#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/village/Village.h"
#include "worlds/records/Materials.h"

namespace limen::worlds {

WorldRecords buildBuiltInWorld(Pictures pictures) {
    WorldRecords records;
    addMaterials(records, pictures);
    ModelWriter sink(records);
    const Plants plants = addPlants(sink);
    addRegion(sink, plants);
    const VillageMap map = addVillage(sink, plants);
    const DungeonMap dungeons = addDungeonBlocks(sink, map.furniture, plants);
    addLandBlocks(records, {kVillage, kTowerBlock, kCaveBlock});
    records.worldFile = buildWorldFile(map, dungeons);
    return records;
}

} // namespace limen::worlds
