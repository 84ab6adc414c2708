#include "world/assemble/AssembleWorld.h"

#include "world/assemble/DoorAssembler.h"
#include "world/assemble/EmitterAssembler.h"
#include "world/assemble/ObjectAssembler.h"
#include "world/assemble/PlacedAssembler.h"
#include "world/assemble/SkyAssembler.h"
#include "world/assemble/SpaceAssembler.h"
#include "world/assemble/StructureAssembler.h"
#include "world/assemble/TerrainAssembler.h"
#include "world/assemble/VillagerAssembler.h"

#include <algorithm>
#include <array>

namespace limen::world {
namespace {

void append(const std::vector<Finding>& findings, World& world) {
    world.findings.insert(world.findings.end(), findings.begin(), findings.end());
}

/// The Region of a world that has a sky, else null.
const dat::Region* regionWithSky(const dat::Region* region) {
    return region != nullptr && (region->partsMask & dat::Region::kSky) != 0 ? region : nullptr;
}

/// The first three rows of the Region's ground textures name the grain of the ground, of exteriors and of
/// shells, whatever the terrain types of the rows are.
Details detailsOf(const dat::Region& region, const Readings& readings, Materials& materials) {
    Details details;
    const std::size_t count =
        readings.details == DetailPictures::On ? 3 : 1; // the option concerns walls alone
    const std::vector<dat::TerrainTexture>& rows = region.texMerge.textures;
    const std::array<DetailPicture*, 3> pictures{&details.land, &details.exteriors, &details.shells};
    for (std::size_t i = 0; i < std::min(count, rows.size()); ++i) {
        constexpr std::uint32_t kMostTiling = 1024;
        if (rows[i].detailTexture != 0 && rows[i].detailTiling != 0)
            *pictures[i] = {materials.plainTexture(rows[i].detailTexture),
                            static_cast<float>(std::min(rows[i].detailTiling, kMostTiling))};
    }
    return details;
}

} // namespace

World assembleWorld(const AssemblySources& sources, const NextBlock& nextBlock, const MovingEntries& moving) {
    auto& [records, models, region, pictures, readings] = sources;
    World world;
    world.readings = readings;
    MeshArena arena(world);
    Materials materials(records, world, pictures);
    MaterialRuns runs(materials, world);
    Cycles cycles(records, world);
    BodyAssembler bodies(models, runs, cycles, arena, world);
    ParticleStyleAssembler styles(records, models, runs, arena, world);
    ParticleAssembler particles(records, styles, cycles, world);
    IdleAssembler idle(bodies, cycles, world);

    SpaceAssembler spaces(world);
    TerrainAssembler terrain(region, materials, arena, world);
    StructureAssembler structures(runs, arena, world);
    ObjectAssembler objects(idle, particles, models, runs, arena, world);
    UsableAssembler usables(records, models, bodies, world);
    PlacedAssembler placed(moving.placed, records, objects, usables, world);
    while (const std::shared_ptr<const BlockContent> content = nextBlock()) {
        records.report(content->recordFindings);
        const JoiningBlock block = spaces.add(*content);
        terrain.add(block);
        structures.add(block);
        objects.add(block);
        placed.add(block);
        append(content->findings, world);
    }
    spaces.finish();

    DoorAssembler doors(bodies, models, runs, arena, world);
    for (std::size_t i = 0; i < moving.doors.size(); ++i)
        doors.add(moving.doors[i], i);
    PlacedDoorAssembler placedDoors(records, models, doors, bodies, world);
    placed.addDoors(placedDoors);
    VillagerAssembler villagers(records, bodies, particles, world);
    for (std::size_t i = 0; i < moving.villagers.size(); ++i)
        villagers.add(moving.villagers[i], i, moving.routes);
    EmitterAssembler emitters(runs, arena, world);
    for (const EmitterEntry& entry : moving.emitters)
        emitters.add(entry);
    if (region != nullptr)
        emitters.addRainDrop();
    if (moving.player != 0) {
        world.player.solid = bodies.add(
            moving.player, InstanceKind::Dynamic, dynamicObject(DynamicObject::Player, 0),
            {.isAlwaysNear = true,
             .dress = dressOf(moving.player, {moving.playerClothing, moving.playerPalette}, records)});
        world.player.ghost = bodies.addBlended(world.player.solid);
    }
    if (region != nullptr)
        world.details = detailsOf(*region, readings, materials);
    const dat::Region* const sky = regionWithSky(region);
    if (sky != nullptr)
        particles.addWeather(sky->sky);

    findMembers(objects.groups(), world);
    findAlone(world);
    listInstances(world);
    numberPolygons(world);
    lightWorld(objects.lamps(), objects.groups(), world);
    if (sky != nullptr) {
        world.sky.desc = sky->sky;
        world.sky.time = sky->gameTime;
        SkyAssembler(models, runs, arena, world).add(sky->sky);
    }
    append(records.findings(), world);
    return world;
}

} // namespace limen::world
