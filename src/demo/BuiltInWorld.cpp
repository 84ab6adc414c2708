#include "demo/BuiltInWorld.h"

#include "demo/DungeonBlocks.h"
#include "demo/Materials.h"
#include "demo/RegionBuilder.h"
#include "demo/TerrainShape.h"
#include "demo/Village.h"

namespace limen::demo {

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

} // namespace limen::demo
