#include "worlds/builtin/dungeon/DungeonBlocks.h"

#include "worlds/builtin/dungeon/Cave.h"
#include "worlds/builtin/dungeon/Tower.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/pictures/Noise.h"
#include "worlds/records/LandblockWriter.h"

namespace limen::worlds {

namespace {

/// Puts a model on the ground.
void stand(LandblockWriter& block, dat::BlockCoord coord, dat::RecordId model, double x, double y,
           double turn) {
    const Vec3 area = toArea(coord, {x, y, 0.0});
    block.addObject({model, {{x, y, landHeight(area.x, area.y)}, turn}});
}

void addTowerBlock(ModelWriter& writer, const DungeonProps& props, const Plants& plants, DungeonMap& map) {
    LandblockWriter block(writer, kTowerBlock, kBuiltInCells);
    map.tower = {{108.0, 108.0, towerLevel() + kTowerSill}, 0.0};
    map.towerCells = block.add(linkedByPoints(planTower(writer, props)), map.tower);
    stand(block, kTowerBlock, props.mast, 98.5, 102.5, 10.0);
    for (int k = 0; k < 5; ++k) {
        const double a = 0.9 + 0.55 * k;
        stand(block, kTowerBlock, props.stele, 108.0 + 10.5 * std::cos(a), 108.0 + 10.5 * std::sin(a),
              a * 57.29577951308232 + 90.0);
    }
    stand(block, kTowerBlock, props.house.barrel, 105.6, 102.3, 0.0);
    stand(block, kTowerBlock, props.house.crate, 104.7, 102.0, 20.0);
    stand(block, kTowerBlock, plants.boulder, 117.6, 99.0, 60.0);
    stand(block, kTowerBlock, plants.bush, 101.0, 114.0, 0.0);
    block.finish();
}

void addCaveBlock(ModelWriter& writer, const DungeonProps& props, const Plants& plants, DungeonMap& map) {
    LandblockWriter block(writer, kCaveBlock, kBuiltInCells);
    CavePlan plan = planCave(writer, props);
    map.parts = plan.parts;
    map.chamber = plan.chamber;
    map.cave = {{84.0, 23.5, caveLevel() + kCaveSill}, 0.0};
    map.caveCells = block.add(linkedByPoints(std::move(plan.building)), map.cave);
    stand(block, kCaveBlock, props.stele, 79.4, 18.6, 20.0);
    stand(block, kCaveBlock, props.stele, 88.9, 18.2, -15.0);
    stand(block, kCaveBlock, props.brazier, 81.0, 20.5, 0.0);
    stand(block, kCaveBlock, props.brazier, 87.2, 20.4, 50.0);
    stand(block, kCaveBlock, plants.boulder, 75.4, 22.0, 0.0);
    stand(block, kCaveBlock, plants.boulder, 92.6, 21.2, 130.0);
    stand(block, kCaveBlock, plants.rock, 90.2, 14.0, 20.0);
    stand(block, kCaveBlock, plants.youngPine, 74.0, 13.0, 0.0);
    stand(block, kCaveBlock, plants.bush, 94.0, 15.5, 0.0);
    for (std::uint32_t k = 0; k < 40; ++k) {
        const double x = 73.0 + 22.0 * random01(k, 1, 6201);
        const double y = 1.0 + 21.0 * random01(k, 2, 6201);
        if (std::abs(x - 84.0) > 2.5) {
            stand(block, kCaveBlock, k % 3 == 0 ? plants.flowers : plants.grass, x, y,
                  360.0 * random01(k, 3, 6201));
        }
    }
    block.finish();
}

void addSealedBlock(ModelWriter& writer, const DungeonProps& props, DungeonMap& map) {
    LandblockWriter block(writer, kSealedBlock, kBuiltInCells);
    map.sealed = {{96.0, 96.0, -24.0}, 0.0};
    map.sealedCells =
        block.add(linkedByPoints({"sealed", {}, planSealedDungeon(writer, props), {}}), map.sealed);
    block.finish();
    dat::LandBlock land;
    land.id = dat::landBlockId(kSealedBlock);
    land.hasObjects = 1;
    writer.records().landBlocks.push_back(land);
}

} // namespace

DungeonMap addDungeonBlocks(ModelWriter& writer, const Furniture& furniture, const Plants& plants) {
    const DungeonProps props = addDungeonProps(writer, furniture);
    DungeonMap map;
    addTowerBlock(writer, props, plants, map);
    addCaveBlock(writer, props, plants, map);
    addSealedBlock(writer, props, map);
    return map;
}

} // namespace limen::worlds
