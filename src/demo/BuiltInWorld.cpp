#include "demo/BuiltInWorld.h"

#include "demo/Materials.h"
#include "demo/RegionBuilder.h"
#include "demo/TerrainShape.h"
#include "demo/Village.h"

namespace limen::demo {

WorldRecords buildBuiltInWorld(Pictures pictures) {
    WorldRecords records;
    addMaterials(records, pictures);
    ModelSink sink(records);
    addRegion(sink, addPlants(sink));
    const VillageMap map = addVillage(sink);
    addLandBlocks(records, {kVillage});
    records.worldFile = buildWorldFile(map);
    return records;
}

} // namespace limen::demo
