#include "worlds/builtin/village/EastVillage.h"

#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/buildings/MeetingHall.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/people/Folk.h"
#include "worlds/builtin/village/Fillings.h"
#include "worlds/pictures/Noise.h"

namespace limen::worlds {

namespace {

/// A torch on a wall: back to the north, its flame at (0, -0.32, 0.28).
dat::RecordId addWallTorch(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-0.07, -0.02, -0.16}, {0.07, 0.02, 0.10}, Material::Iron);
    mesh.strut({0.0, -0.02, -0.06}, {0.0, -0.28, -0.06}, {1, 0, 0}, 0.03, 0.03, Material::Iron);
    mesh.strut({0.0, -0.20, -0.28}, {0.0, -0.32, 0.16}, {1, 0, 0}, 0.055, 0.055, Material::Bark);
    mesh.strut({0.0, -0.305, 0.10}, {0.0, -0.335, 0.22}, {1, 0, 0}, 0.10, 0.10, Material::Embers);
    return writer.addSetup({{writer.addMesh(mesh), {}}}, {{{0.0, -0.40, 0.40}, 0xFFFF9C50, 0.7, 9.0}});
}

void standTorches(ModelWriter& writer, LandblockWriter& block, const VillageMap& map) {
    const dat::RecordId torch = addWallTorch(writer);
    for (const Vec3& at : hallTorches()) {
        // Its back faces +x of the hall.
        block.addObject({torch, {place(map.hall, at), map.hall.turn - 90.0}});
    }
}

void standProps(LandblockWriter& block, const VillageModels& m) {
    stand(block, m.props.bench, 105.8, 103.5, 0.0);
    stand(block, m.props.bench, 114.4, 103.5, 0.0);
    stand(block, m.furniture.barrel, 117.6, 103.45, 20.0);
    stand(block, m.furniture.barrel, 116.9, 103.3, 75.0);
    stand(block, m.props.trough, 104.0, 102.2, 5.0);
    stand(block, m.props.woodpile, 101.9, 108.0, -90.0);
    stand(block, m.props.woodpile, 101.9, 112.4, -90.0);
    stand(block, m.furniture.crate, 114.6, 115.8, 10.0);
    stand(block, m.furniture.barrel, 115.6, 115.6, 0.0);
    stand(block, m.furniture.sacks, 111.6, 115.7, 0.0);
    stand(block, m.props.lampPost, 107.3, 99.9, 0.0);
    stand(block, m.props.bench, 106.9, 90.15, 180.0);
    stand(block, m.props.bench, 114.1, 90.15, 180.0);
    stand(block, m.props.signpost, 121.0, 99.6, 180.0);
}

void plant(LandblockWriter& block, const Plants& plants) {
    stand(block, plants.oak, 99.0, 122.0, 20.0);
    stand(block, plants.birch, 120.6, 117.6, 130.0);
    stand(block, plants.oak, 123.0, 108.0, 200.0);
    stand(block, plants.birch, 98.6, 83.0, 60.0);
    stand(block, plants.oak, 120.4, 80.0, 310.0);
    stand(block, plants.birch, 119.2, 88.6, 10.0);
    for (std::uint32_t k = 0; k < 110; ++k) {
        const double x = 96.5 + 23.0 * random01(k, 1, 5101);
        const double y = 72.5 + 47.0 * random01(k, 2, 5101);
        const bool inInn = x > 101.4 && x < 119.6 && y > 101.6 && y < 116.2;
        const bool inHall = x > 104.2 && x < 116.8 && y < 91.4;
        const bool onLane = y > 90.0 && y < 102.0;
        if (inInn || inHall || onLane)
            continue;
        const double pick = random01(k, 3, 5101);
        stand(block,
              pick < 0.08   ? plants.bush
              : pick < 0.4  ? plants.flowers
              : pick < 0.75 ? plants.grass
                            : plants.tallGrass,
              x, y, 360.0 * random01(k, 4, 5101));
    }
    for (const double x : {103.3, 104.7, 107.0, 113.4, 116.0})
        stand(block, plants.flowers, x, 103.4 + 0.12 * std::sin(7.0 * x), 50.0 * x);
}

} // namespace

void stand(LandblockWriter& block, dat::RecordId model, double x, double y, double turn) {
    block.addObject({model, {{x, y, landHeight(192.0 + x, 192.0 + y)}, turn}});
}

void addEastVillage(ModelWriter& writer, LandblockWriter& block, const VillageModels& models,
                    VillageMap& map) {
    const double floor = siteLevel() + kFloorAboveGround;
    map.inn = {{110.5, 104.0, floor}, 0.0};
    map.hall = {{110.5 - hall::kMiddle, 83.125, floor}, -90.0};
    map.innCells = block.add(linkedByPoints(planInn(writer, models.furniture)), map.inn);
    map.hallCells = block.add(linkedByPoints(planMeetingHall(writer, models.furniture)), map.hall);
    standProps(block, models);
    standTorches(writer, block, map);
    plant(block, models.plants);
    map.doors = buildDoors(writer, map);
    addFolk(writer, models.effects, map);
}

} // namespace limen::worlds
