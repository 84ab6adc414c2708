#include "PlannedWorld.h"

#include "frame/PlanSky.h"
#include "frame/ReadingDefines.h"
#include "frame/SceneBuilder.h"

#include <gmock/gmock.h>

// Readings of open questions about the formats, as far as plans and scenes follow them.
namespace limen::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using world::Readings;

TEST(ReadingDefines, areNoneForTheDefaults) {
    EXPECT_THAT(frame::definesOf({}), IsEmpty());
    Readings others; // readings that no shader follows
    others.skyPlace = world::SkyPlace::Cell;
    others.skyParticles = world::SkyParticles::None;
    others.details = world::DetailPictures::Off;
    others.levelBias = -1.0;
    EXPECT_THAT(frame::definesOf(others), IsEmpty());
}

TEST(ReadingDefines, areOneForEachReadingOfLight) {
    Readings readings;
    readings.cellFog = world::CellFog::None;
    readings.wallEmission = world::WallEmission::Replaced;
    readings.surfaceDiffuse = world::SurfaceDiffuse::Sun;
    readings.normals = world::ScaledNormals::Scaled;
    readings.grain = world::GroundGrain::Unlit;
    readings.wallGrey = 0.25;
    EXPECT_THAT(frame::definesOf(readings),
                ElementsAre("NO_CELL_FOG", "BAKED_LIGHT_REPLACES", "SURFACE_DIFFUSE", "NORMALS_SCALED",
                            "GRAIN_UNLIT", "WALL_GREY 0.250000"));
    Readings divided;
    divided.normals = world::ScaledNormals::Divided;
    EXPECT_THAT(frame::definesOf(divided), ElementsAre("NORMALS_DIVIDED"));
}

TEST(BuildScene, hasTheMacrosOfItsWorldsReadings_andTheDiffuseValuesOfItsSurfaces) {
    Rooms rooms;
    rooms.world.luminous("brown", 0.5f, 0.25f, 0);
    world::LoadOptions options;
    options.readings.cellFog = world::CellFog::None;
    const world::World world = loadTestWorld(rooms.world, options);
    EXPECT_EQ(world.readings, options.readings);
    const frame::SceneUpload upload = frame::buildScene(frame::StaticScene(world));
    EXPECT_THAT(upload.defines, ElementsAre("NO_CELL_FOG"));
    ASSERT_EQ(upload.materials.size(), world.materials.size());
    for (std::size_t i = 0; i < world.materials.size(); ++i)
        EXPECT_EQ(upload.materials[i].diffuse, world.materials[i].diffuse);
    EXPECT_THAT(frame::buildScene(frame::StaticScene(loadTestWorld(rooms.world))).defines, IsEmpty());
}

/// A moon that does not move, above two rooms.
struct MoonlitRooms {
    Rooms rooms;
    MoonlitRooms() {
        dat::SkyObject moon;
        moon.object = rooms.world.addModel({Wall{rectangle({-5, 900, 50}, {5, 900, 60}), "white", true}});
        rooms.world.region().sky.dayGroups.at(0).objects = {moon};
    }
};

/// The origin of the only sky object, global.
Vec3 originSeenFrom(PlannedWorld& planned, const Vec3& local, world::SpaceIndex root) {
    const frame::FrameView view = frame::makeView(planned.origin + local, 0.0, 0.0, 75.0, 320, 200, root);
    std::vector<world::SkyPlacement> placements;
    frame::placeSky(planned.world, view, root, placements);
    EXPECT_EQ(placements.size(), 1u);
    return placements.empty() ? Vec3(0.0) : view.view.eye + Vec3(placements[0].offset);
}

void expectNear(const Vec3& place, const Vec3& expected) {
    EXPECT_LT(glm::length(place - expected), 1e-3) << place.x << " " << place.y << " " << place.z;
}

TEST(PlaceSky, isAroundTheEye_theCornerOfItsLandblock_orItsCell) {
    MoonlitRooms source;
    TestWorld::CellOptions moved;
    moved.frame = frameAt({41, 42, 1.5});
    source.rooms.world.addBox({40, 40, 0}, {44, 44, 3}, "brown", moved);
    PlannedWorld planned(source.rooms.world);
    const world::SpaceIndex inside =
                                world::findCell(planned.world, source.rooms.world.id(source.rooms.first)),
                            away = static_cast<world::SpaceIndex>(planned.world.spaces.size() - 1);
    const Vec3 outdoors(100.5, 30.25, 17.0), indoors(92, 91, 1.5);
    expectNear(originSeenFrom(planned, outdoors, world::kOutside), planned.origin + outdoors);
    expectNear(originSeenFrom(planned, indoors, inside), planned.origin + indoors);
    planned.world.readings.skyPlace = world::SkyPlace::Block;
    expectNear(originSeenFrom(planned, outdoors, world::kOutside), planned.origin);
    expectNear(originSeenFrom(planned, indoors, inside), planned.origin);
    planned.world.readings.skyPlace = world::SkyPlace::Cell;
    expectNear(originSeenFrom(planned, outdoors, world::kOutside), planned.origin + Vec3(96, 24, 0));
    expectNear(originSeenFrom(planned, {42, 42, 1}, away), planned.origin + Vec3(41, 42, 1.5));
}

TEST(PlaceSky, isThatOfTheSpaceInWhichRaysBegin) {
    MoonlitRooms source;
    source.rooms.world.region().sky.dayGroups.at(0).objects.at(0).properties = 1; // over the land
    PlannedWorld planned(source.rooms.world);
    const world::SpaceIndex room = world::findCell(planned.world, source.rooms.world.id(source.rooms.second));
    for (const frame::Gate gate : {frame::Gate::Ownership, frame::Gate::Planes}) {
        planned.gate = gate;
        const auto objectsFrom = [&](double past) {
            return planned.planFrom({92, 98 + past, 1.0}, 0.0, room).skyInstances.size();
        };
        EXPECT_EQ(objectsFrom(-0.5), 0u) << "nothing is over the land for an eye indoors";
        EXPECT_EQ(objectsFrom(0.0001), 1u) << "the eye has just passed the exit of its root";
        EXPECT_EQ(planned.visible.visits[0].space, world::kOutside);
    }
}

} // namespace
} // namespace limen::test
