#include "worlds/BuiltInWorld.h"

#include "worlds/builtin/dungeon/DungeonBlocks.h"
#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/village/DoorMotions.h"
#include "worlds/builtin/village/Village.h"
#include "worlds/records/Materials.h"

namespace limen::worlds {

WorldRecords buildBuiltInWorld(Pictures pictures) {
    WorldRecords records;
    addMaterials(records, pictures);
    ModelWriter writer(records);
    const Plants plants = pictures == Pictures::Painted
                              ? addPlants(writer, paintMaterial, 128)
                              : addPlants(
                                    writer, [](Material) { return blankPicture(); }, 32);
    addRegion(writer, plants);
    const VillageMap map = addVillage(writer, plants);
    const DungeonMap dungeons = addDungeonBlocks(writer, map.furniture, plants);
    addLandBlocks(records, {kVillage, kTowerBlock, kCaveBlock});
    records.worldFile = buildWorldFile(map, dungeons);
    addDoorMotions(writer, records.worldFile);
    return records;
}

} // namespace limen::worlds
