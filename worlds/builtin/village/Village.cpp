#include "worlds/builtin/village/Village.h"

#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/effects/Effects.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/village/EastVillage.h"
#include "worlds/builtin/village/OutdoorProps.h"
#include "worlds/pictures/Noise.h"

namespace limen::worlds {

namespace {

/// Adds a row of fence pieces along x, 3 m each, without those that overlap the gap.
void fenceRow(LandblockWriter& block, dat::RecordId fence, double y, double from, double to, double gapFrom,
              double gapTo) {
    for (double x = from; x + 3.0 <= to + 1e-9; x += 3.0)
        if (x + 3.0 <= gapFrom || x >= gapTo)
            stand(block, fence, x, y, 0.0);
}

/// Places plants in landcells with a house, because scenery is not generated there.
void plantGardens(LandblockWriter& block, const Plants& plants) {
    stand(block, plants.oak, 87.6, 126.5, 40.0);
    stand(block, plants.birch, 80.6, 128.5, 200.0);
    stand(block, plants.oak, 95.5, 117.5, 110.0);
    stand(block, plants.birch, 74.2, 104.6, 0.0);
    stand(block, plants.pine, 73.2, 117.6, 80.0);
    stand(block, plants.oak, 74.6, 77.0, 15.0);
    stand(block, plants.birch, 93.6, 76.4, 250.0);
    stand(block, plants.boulder, 85.6, 131.0, 30.0);
    for (std::uint32_t k = 0; k < 90; ++k) {
        // Along the walls and on the lawns, clear of houses, doors and paths.
        const double x = 72.5 + 23.0 * random01(k, 1, 5001);
        const double y = 73.0 + 46.0 * random01(k, 2, 5001);
        const bool inCottage = x > 76.6 && x < 91.4 && y > 104.9 && y < 117.2;
        const bool inNeighbour = x > 78.9 && x < 89.1 && y > 77.8 && y < 87.2;
        const bool onPath = std::abs(x - 84.0) < 1.6 || (y > 90.0 && y < 102.0);
        if (inCottage || inNeighbour || onPath)
            continue;
        const double pick = random01(k, 3, 5001);
        stand(block,
              pick < 0.1 && std::abs(y - 96.0) > 11.5 ? plants.bush
              : pick < 0.5                            ? plants.flowers
              : pick < 0.8                            ? plants.grass
                                                      : plants.tallGrass,
              x, y, 360.0 * random01(k, 4, 5001));
    }
    for (const double x : {78.9, 79.9, 80.5, 86.9, 88.3, 89.2})
        stand(block, plants.flowers, x, 105.45 + 0.12 * std::sin(7.0 * x), 50.0 * x);
}

} // namespace

VillageMap addVillage(ModelWriter& writer, const Plants& plants) {
    const Effects effects = addEffects(writer);
    const Furniture furniture = addFurniture(writer);
    writer.setEffects(furniture.candle, {.script = effects.candleScript});
    const OutdoorProps props = addOutdoorProps(writer);
    LandblockWriter block(writer, kVillage, kBuiltInCells);
    VillageMap map;
    map.furniture = furniture;
    const double floor = siteLevel() + kFloorAboveGround;
    map.cottage = {{84.0, 106.0, floor}, 0.0};
    map.neighbour = {{84.0, 86.0, floor}, 180.0};
    map.cottageCells = block.add(linkedByPoints(planCottage(writer, furniture)), map.cottage);
    map.neighbourCells = block.add(linkedByPoints(planNeighbour(writer, furniture)), map.neighbour);
    fenceRow(block, props.fence, 101.2, 67.5, 103.5, 82.4, 85.6);
    fenceRow(block, props.fence, 90.6, 67.5, 100.5, 82.4, 85.6);
    fenceRow(block, props.fence, 122.5, 72.0, 99.0, 0.0, 0.0);
    stand(block, props.well, 92.4, 103.9, 25.0);
    stand(block, props.trough, 95.2, 103.0, 80.0);
    stand(block, props.woodpile, 77.35, 110.6, -90.0);
    stand(block, props.bench, 87.5, 105.35, 0.0);
    stand(block, props.signpost, 70.6, 100.3, 0.0);
    stand(block, props.lampPost, 89.4, 100.7, 0.0);
    stand(block, effects.fountain, 79.0, 99.6, 0.0);
    stand(block, effects.campfire, 94.5, 91.9, 20.0);
    stand(block, effects.whirligig, 72.5, 92.2, 30.0);
    stand(block, effects.vane, 75.5, 100.6, 60.0);
    stand(block, furniture.barrel, 82.2, 105.3, 0.0);
    stand(block, furniture.barrel, 81.4, 105.45, 60.0);
    stand(block, furniture.crate, 86.6, 86.6, 12.0);
    stand(block, props.bench, 81.2, 86.7, 180.0);
    stand(block, props.woodpile, 89.0, 82.0, 90.0);
    plantGardens(block, plants);
    addEastVillage(writer, block, {furniture, props, plants, effects}, map);
    block.finish();
    return map;
}

} // namespace limen::worlds
