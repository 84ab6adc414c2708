#include "worlds/BuiltInWorld.h"

#include "worlds/DungeonBlocks.h"
#include "worlds/Materials.h"
#include "worlds/RegionBuilder.h"
#include "worlds/TerrainShape.h"
#include "worlds/Village.h"

namespace limen::worlds {

WorldRecords buildBuiltInWorld(Pictures pictures) {
    WorldRecords records;
    addMaterials(records, pictures);
    ModelSink sink(records);
    const Plants plants = addPlants(sink);
    addRegion(sink, plants);
    const VillageMap map = addVillage(sink, plants);
    const DungeonMap dungeons = addDungeonBlocks(sink, map.furniture, plants);
    addLandBlocks(records, {kVillage, kTowerBlock, kCaveBlock});
    records.worldFile = buildWorldFile(map, dungeons);
    return records;
}

} // namespace limen::worlds
