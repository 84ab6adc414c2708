#include "PlannedWorld.h"

#include "frame/DrawRecords.h"
#include "frame/SceneBuilder.h"
#include "world/LevelRange.h"
#include "world/Lookup.h"

#include <map>
#include <set>
#include <tuple>

namespace limen::test {
namespace {

/// The two rooms, with a lamp in the first and a post of two levels outside.
struct Recorded {
    Rooms rooms;
    Recorded() {
        const auto post = [](double half) {
            return insideOut(boxWalls({-half, -half, 0}, {half, half, 2}, "red"));
        };
        const std::uint32_t thin = rooms.world.addModel(post(0.1));
        const std::uint32_t fine =
            rooms.world.addModel(post(0.2), {{TestWorld::kItself, dat::DegradeLevel::kMesh, 0, 8, 8},
                                             {thin, dat::DegradeLevel::kMesh, 0, 60, 60}});
        rooms.world.addObject(fine, frameAt({92, 120, 0}));
    }
};

TEST(DrawRecords, placeAnInstanceAsItsPoseDoes_whereverTheEyeIs) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    const frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    const world::SpaceIndex outside = world::kOutside;
    for (const Vec3& eye : {Vec3(92, 125, 1.6), Vec3(30.25, 180.5, 40)}) {
        const frame::FramePlan& plan = planned.planFrom(eye, 180.0, outside);
        const frame::DrawRecords records(tables, plan, {});
        for (std::uint32_t i = 0; i < planned.world.instances.size(); ++i) {
            const world::Instance& instance = planned.world.instances[i];
            const frame::gpu::DrawRecord record = records.of(i);
            const Vec3f model(0.3f, -0.2f, 1.1f);
            const Vec3 expected = planned.world.blocks[instance.block].origin() + Vec3(instance.origin) +
                                  Vec3(instance.linear * model) - planned.view.view.eye;
            const Vec3 placed(glm::dot(Vec3f(record.row0), model) + record.row0.w + record.rest.x,
                              glm::dot(Vec3f(record.row1), model) + record.row1.w + record.rest.y,
                              glm::dot(Vec3f(record.row2), model) + record.row2.w + record.rest.z);
            EXPECT_LT(glm::length(placed - expected), 2e-5) << i;
            EXPECT_EQ(record.members.z, instance.idBase);
            EXPECT_EQ(record.look.x, instance.firstMaterial);
        }
    }
}

/// The visits of a plan to the zones of a static instance, a bit each.
std::uint64_t visitsToZonesOf(const PlannedWorld& planned, const frame::FramePlan& plan,
                              std::uint32_t number) {
    const world::Instance& instance = planned.world.instances[number];
    std::uint64_t bits = 0;
    for (std::uint32_t visit = 0; visit < plan.constants.visitCount; ++visit)
        for (std::uint32_t m = 0; m < instance.memberCount; ++m)
            if (planned.world.spaces[planned.world.members[instance.firstMember + m]].zone ==
                plan.visits[visit].zone)
                bits |= std::uint64_t{1} << visit;
    return bits;
}

TEST(DrawRecords, haveABitForEachVisitToTheirZones) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    const world::SpaceIndex first = world::findCell(planned.world, source.rooms.world.id(source.rooms.first));
    const frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    frame::VisitBits visits; // reused: nothing of the plan before is left
    std::set<std::uint64_t> found;
    for (const double yaw : {0.0, 180.0}) {
        const frame::FramePlan& plan = planned.planFrom({92, 91, 1.5}, yaw, first);
        visits.prepare(plan);
        const frame::DrawRecords records(tables, plan, {});
        for (std::uint32_t i = 0; i < planned.world.instances.size(); ++i) {
            const std::uint64_t bits = records.visitsTo(i, visits);
            EXPECT_EQ(bits, visitsToZonesOf(planned, plan, i)) << i;
            found.insert(bits);
        }
    }
    EXPECT_GE(found.size(), 4u) << "none, and each of three visits";
}

TEST(DrawRecords, drawTheLevelsThatTheWorldDraws) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    const frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    std::set<std::vector<bool>> drawn;
    for (double y = 121.0; y < 190.0; y += 3.7) {
        planned.levels = {y < 150.0 ? 16u : 11u};
        const frame::FramePlan& plan = planned.planFrom({92, y, 1.6}, 180.0, world::kOutside);
        const frame::DrawRecords records(tables, plan, {});
        const world::RangeSteps eye = world::rangeStepsOf(planned.view.view.eye);
        std::vector<bool> here;
        for (std::uint32_t i = 0; i < planned.world.instances.size(); ++i) {
            here.push_back(records.isInRange(i));
            EXPECT_EQ(here.back(),
                      world::isInLevelRange(planned.world, planned.world.instances[i], eye, planned.levels));
        }
        drawn.insert(here);
    }
    EXPECT_EQ(drawn.size(), 2u) << "the post has two levels";
}

TEST(DrawRecords, aReplacedInstanceHasTheOthersRecord) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    const frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    frame::FramePlan plan = planned.planFrom({92, 125, 1.6}, 180.0, world::kOutside);
    frame::gpu::Instance other = tables.instances[1];
    other.highlight = 0xFF0000FFu;
    const std::vector<frame::gpu::Instance> own{other};
    plan.replacements = {{1, static_cast<std::uint32_t>(tables.instances.size())}};
    const frame::DrawRecords records(tables, plan, own);
    EXPECT_EQ(records.of(1).look.y, 0xFF0000FFu);
    EXPECT_EQ(records.of(0).look.y, 0u);
}

TEST(DrawRecords, haveTheLampsOfTheirLightSets) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    const frame::FramePlan& plan = planned.planFrom({92, 125, 1.6}, 180.0, world::kOutside);
    const frame::DrawRecords records(tables, plan, {});
    const world::SpaceIndex cell = world::findCell(planned.world, source.rooms.world.id(source.rooms.first));
    const world::InstanceIndex shell = planned.world.spaces[cell].shell;
    EXPECT_FALSE(records.hasLamps(shell));
    EXPECT_EQ(records.of(shell).members.w,
              frame::gpu::kLitWalls | frame::gpu::kDetailOfShells << frame::gpu::kRecordDetail);
    tables.lightSets[tables.members[tables.instances[shell].firstMember].lightSet].lampCount = 3;
    EXPECT_TRUE(records.hasLamps(shell));
    EXPECT_EQ(records.of(shell).look.w, 3u);
}

TEST(DrawRecords, haveSunAndSkyOutdoors_noSunInCells) {
    Recorded source;
    source.rooms.world.record(source.rooms.second).flags |= dat::EnvCell::kSeenOutside;
    PlannedWorld planned(source.rooms.world);
    const frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    frame::FramePlan plan = planned.planFrom({92, 125, 1.6}, 180.0, world::kOutside);
    plan.constants.sunColour = {0.5f, 0.5f, 0.5f, 0};
    plan.constants.landAmbient = {0.25f, 0, 0, 0};
    plan.constants.skyAmbient = {0, 0.25f, 0, 0};
    plan.constants.sealedAmbient = {0, 0, 0.25f, 0};
    const frame::DrawRecords records(tables, plan, {});
    std::set<std::tuple<world::InstanceKind, float, float, float, float>>
        found; // ambient, and red of the sun
    for (std::uint32_t i = 0; i < planned.world.instances.size(); ++i) {
        const frame::gpu::DrawRecord record = records.of(i);
        found.insert({planned.world.instances[i].kind, record.ambient.x, record.ambient.y, record.ambient.z,
                      record.sun.x});
    }
    EXPECT_EQ(found.count({world::InstanceKind::Terrain, 0.25f, 0.0f, 0.0f, 0.5f}), 1u);
    EXPECT_EQ(found.count({world::InstanceKind::Static, 0.0f, 0.25f, 0.0f, 0.5f}), 1u);
    EXPECT_EQ(found.count({world::InstanceKind::Shell, 0.0f, 0.25f, 0.0f, 0.0f}), 1u) << "sees the outside";
    EXPECT_EQ(found.count({world::InstanceKind::Shell, 0.0f, 0.0f, 0.25f, 0.0f}), 1u) << "sealed";
    EXPECT_EQ(found.count({world::InstanceKind::Static, 0.0f, 0.25f, 0.0f, 0.0f}), 1u) << "a table there";
    EXPECT_EQ(found.count({world::InstanceKind::Static, 0.0f, 0.0f, 0.25f, 0.0f}), 1u);
    EXPECT_EQ(found.count({world::InstanceKind::Exterior, 0.0f, 0.25f, 0.0f, 0.5f}), 1u);
}

TEST(Planner, placesLampsAndLetsTheNearestFortyShine) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    const Vec3 eye(92, 125, 1.6);
    static_cast<void>(planned.planFrom(eye, 180.0, world::kOutside));
    for (int i = 0; i < 50; ++i)
        planned.world.lights.push_back(
            {planned.view.view.eye + Vec3(50.0 - i, 0, 0), Vec3f(1, 0.5f, 0), 3.0f, 9.0f});
    planned.planner.plan(planned.view, planned.visible, planned.plan);
    ASSERT_EQ(planned.plan.lamps.size(), 50u);
    for (int i = 0; i < 50; ++i) {
        const frame::gpu::Lamp& lamp = planned.plan.lamps[static_cast<std::size_t>(i)];
        EXPECT_NEAR(lamp.position.x, 50.0 - i, 1e-5);
        EXPECT_EQ(lamp.position.w, 9.0f);
        EXPECT_EQ(lamp.colour, Vec4f(1, 0.5f, 0, i < 10 ? 0.0f : 3.0f)) << i;
    }
}

TEST(Planner, placesTheViewersLight) {
    Recorded source;
    PlannedWorld planned(source.rooms.world);
    EXPECT_EQ(planned.planFrom({92, 125, 1.6}, 180.0, world::kOutside).constants.viewerLight.w, 0.0f);
    planned.view.viewerLight = planned.view.view.eye + Vec3(1, 2, 3);
    planned.planner.plan(planned.view, planned.visible, planned.plan);
    EXPECT_EQ(planned.plan.constants.viewerLight, Vec4f(1, 2, 3, 2.25f));
    EXPECT_EQ(planned.plan.constants.sealedAmbient, Vec4f(0.2f, 0.2f, 0.2f, 0));
}

/// Whether the shells of the rooms take the ownership test.
std::map<world::InstanceIndex, bool> gatedShells(PlannedWorld& planned, const Vec3& eye, double yaw,
                                                 world::SpaceIndex root, bool fewTests) {
    static_cast<void>(planned.planFrom(eye, yaw, root));
    planned.view.fewTests = fewTests;
    planned.planner.plan(planned.view, planned.visible, planned.plan);
    std::map<world::InstanceIndex, bool> gated;
    for (const frame::PieceRun& run : planned.plan.runs)
        for (const frame::gpu::DrawPiece& piece : planned.piecesOf(run))
            if ((piece.triangles & frame::gpu::kNeverCulled) == 0 &&
                piece.instance < planned.world.instances.size() &&
                planned.world.instances[piece.instance].kind == world::InstanceKind::Shell)
                gated[piece.instance] = run.gated;
    return gated;
}

TEST(RootExits, theRootsWallsTakeNoTest_othersDo) {
    Rooms rooms;
    PlannedWorld planned(rooms.world);
    const auto first = world::findCell(planned.world, rooms.world.id(rooms.first));
    const auto second = world::findCell(planned.world, rooms.world.id(rooms.second));
    const world::InstanceIndex near = planned.world.spaces[first].shell,
                               far = planned.world.spaces[second].shell;
    const auto exact = gatedShells(planned, {92, 91, 1.6}, 0.0, first, false);
    const auto few = gatedShells(planned, {92, 91, 1.6}, 0.0, first, true);
    EXPECT_TRUE(exact.at(near));
    EXPECT_FALSE(few.at(near)) << "no wall of the eye's room is beyond its door";
    EXPECT_TRUE(few.at(far));
    EXPECT_EQ(exact.size(), few.size());
}

TEST(RootExits, aWallBeyondAnOpeningTakesTheTest) {
    TestWorld source;
    auto walls = boxWalls({90, 90, 0}, {94, 94, 3}, "brown");
    const auto beyond = insideOut(boxWalls({91.5, 95, 1}, {92.5, 95.5, 1.5}, "brown")); // in the other room
    walls.insert(walls.end(), beyond.begin(), beyond.end());
    const TestWorld::Cell here = source.addCell(walls);
    const TestWorld::Cell there = source.addBox({90, 94, 0}, {94, 98, 3}, "blue");
    source.link(here, rectangle({91, 94, 0}, {93, 94, 2}), there);
    PlannedWorld planned(source);
    const auto root = world::findCell(planned.world, source.id(here));
    EXPECT_TRUE(gatedShells(planned, {92, 91, 1.6}, 0.0, root, true).at(planned.world.spaces[root].shell));
}

} // namespace
} // namespace limen::test
