// Hard cases 7 and 15 of docs/cases.md: distant and tall objects.
#include "picture/CaseHelp.h"

namespace limen::test {
namespace {

struct CasesDistance : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesDistance);

/// A street northwards over three blocks: houses 6 m wide, 4 m high, each with a door in the south. Metres
/// are relative to the home block.
struct Street {
    TestWorld world;
    std::vector<TestWorld::Cell> rooms;
    std::vector<double> fronts;

    Street() {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 2; ++y)
                world.setFlatTerrain({world.home().x + x, world.home().y + y}, 1); // 2 m
    }
    TestWorld::Cell addHouse(double x, double front, const std::string& colour) {
        const int block = static_cast<int>(front / world::kBlockSize);
        const dat::BlockCoord coord{world.home().x, world.home().y + block};
        const Vec3 min(x - 3, front - block * world::kBlockSize, 2), max = min + Vec3(6, 6, 4);
        TestWorld::CellOptions cell;
        cell.block = coord;
        rooms.push_back(world.addBox(min, max, colour, cell));
        fronts.push_back(front);
        const auto door =
            world.openOutside(rooms.back(), rectangle({x - 1, min.y, 2.1}, {x + 1, min.y, 4.6}));
        TestWorld::BuildingOptions building;
        building.block = coord;
        models.push_back(world.addBuilding(boxExterior(min, max), {door}, building));
        return rooms.back();
    }
    std::vector<std::uint32_t> models;
};

constexpr double kX = 96.0;
const Vec3 kEye{kX + 0.2, 20, 3.6};

TEST_P(CasesDistance, case07_doorsFourHundredMetresAwayAreSeenInto) {
    Street street;
    const double distances[] = {100, 170, 290, 400};
    for (std::size_t i = 0; i < std::size(distances); ++i) {
        street.addHouse(kX - 12 + 8.0 * static_cast<double>(i), kEye.y + distances[i],
                        i % 2 == 0 ? "brown" : "blue");
    }
    PictureWorld pictures(street.world, options({}, 2));
    for (std::size_t i = 0; i < street.rooms.size(); ++i) {
        SCOPED_TRACE(distances[i]);
        const world::SpaceIndex room = pictures.space(street.world.id(street.rooms[i]));
        const double x = kX - 12 + 8.0 * static_cast<double>(i) - kEye.x;
        const double yaw = std::atan2(x, distances[i]) * 57.29577951308232;
        for (const double fov : {75.0, 10.0, 2.0}) {
            pictures.fov = fov;
            const Picture picture = pictures.expectClean(pictures.look(kEye, yaw, 0, world::kOutside));
            EXPECT_TRUE(visitsSpace(picture, room)) << "no distance cuts a flood off";
            if (fov == 2.0) { // the door, 2 m wide and 2.5 m high
                const double pixelsPerMetre =
                    pictures.height / 2.0 / picture.frame.view.tanHalfY / distances[i];
                EXPECT_GT(
                    static_cast<double>(pixelsOfRecord(pictures, picture, street.world.id(street.rooms[i]))),
                    0.7 * 2.0 * 2.5 * pixelsPerMetre * pixelsPerMetre);
            }
        }
    }
    const Picture away = pictures.expectClean(pictures.look(kEye, 180, 0, world::kOutside));
    EXPECT_EQ(away.visible.visits.size(), 1u) << "nothing behind the eye is flooded";
}

/// Pictures of the street with and without the farther objects must agree where the nearer one shows.
void expectUntouched(const PictureWorld& with, const Picture& a, const PictureWorld& without,
                     const Picture& b, dat::RecordId occluder) {
    std::size_t compared = 0;
    for (std::size_t i = 0; i < b.ids.size(); ++i) {
        const world::Instance* before = shownAs(without.world(), b.ids[i]);
        if (before == nullptr || before->record != occluder)
            continue;
        const world::Instance* now = shownAs(with.world(), a.ids[i]);
        ASSERT_NE(now, nullptr);
        ASSERT_EQ(now->record, occluder) << "pixel " << i;
        ASSERT_EQ(a.ids[i] - now->idBase, b.ids[i] - before->idBase) << "pixel " << i;
        ASSERT_EQ(a.depth[i], b.depth[i]) << "pixel " << i;
        ++compared;
    }
    EXPECT_GT(compared, 30u) << "it is in the picture";
}

TEST_P(CasesDistance, case07_aDoorBehindANearerHouseShowsNothingOfItsInterior) {
    for (const double behind : {100.0, 260.0, 400.0}) {
        SCOPED_TRACE(behind);
        Street both, near;
        for (Street* street : {&near, &both})
            street->addHouse(kX, kEye.y + 40, "brown");
        // In line with the nearer house's wall, east of its door.
        const TestWorld::Cell far = both.addHouse(kEye.x + 1.6 * behind / 40, kEye.y + behind, "blue");
        PictureWorld with(both.world, options({}, 2)), without(near.world, options({}, 2));
        for (const double fov : {30.0, 6.0}) {
            with.fov = without.fov = fov;
            const Picture a = with.expectClean(with.look(kEye, 0, 1, world::kOutside));
            const Picture b = without.expectClean(without.look(kEye, 0, 1, world::kOutside));
            EXPECT_TRUE(visitsSpace(a, with.space(both.world.id(far)))) << "only depth hides it";
            EXPECT_EQ(pixelsOfRecord(with, a, both.world.id(far)), 0u);
            expectUntouched(with, a, without, b, near.models[0]);
            expectUntouched(with, a, without, b, near.world.id(near.rooms[0]));
        }
    }
}

TEST_P(CasesDistance, case07_aDoorBehindAHillShowsNothingOfItsInterior) {
    Street both, bare;
    for (Street* street : {&both, &bare}) // a ridge 8 m high across the block, 96 m before the eye
        for (int x = 0; x <= 8; ++x)
            street->world.terrain(street->world.home()).heights[static_cast<std::size_t>(x * 9 + 5)] = 5;
    const TestWorld::Cell far = both.addHouse(kX, kEye.y + 150, "blue");
    PictureWorld with(both.world, options({}, 2)), without(bare.world, options({}, 2));
    const dat::RecordId ground = dat::landBlockId(both.world.home());
    for (const double fov : {30.0, 6.0}) {
        with.fov = without.fov = fov;
        const Picture a = with.expectClean(with.look(kEye, 0, 0, world::kOutside));
        const Picture b = without.expectClean(without.look(kEye, 0, 0, world::kOutside));
        EXPECT_TRUE(visitsSpace(a, with.space(both.world.id(far))));
        EXPECT_EQ(pixelsOfRecord(with, a, both.world.id(far)), 0u);
        expectUntouched(with, a, without, b, ground);
    }
    with.fov = 6.0;
    const Picture over = with.expectClean(with.look(kEye + Vec3(0, 0, 30), 0, -11.4, world::kOutside));
    EXPECT_GT(pixelsOfRecord(with, over, both.world.id(far)), 5u) << "from above the ridge it is seen";
}

TEST_P(CasesDistance, case15_aTallObjectIsDrawnThoughItsAnchorIsOffScreen) {
    // A leaning mast: its model extends 25 m along +x from its anchor, and its setup turns it upright.
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    const std::uint32_t mast = world.addModel(boxExterior({0, -0.3, -0.3}, {25, 0.3, 0.3}, "oak"));
    dat::Setup setup;
    setup.parts = {mast};
    dat::AnimationFrame pose;
    const float half = std::sqrt(0.5f);
    pose.parts = {{Vec3f(0.0f), Quatf(half, 0.0f, -half, 0.0f)}}; // +x becomes +z
    setup.placementFrames = {{0x65, pose}};
    const std::uint32_t upright = world.addSetup(setup);
    world.addObject(upright, frameAt({96, 100, 0}, 30));
    world.addObject(mast, frameAt({60, 96, 0.5}, 90)); // points along +y
    PictureWorld pictures(world, options());
    pictures.fov = 40;
    const Picture up = pictures.expectClean(pictures.look({96, 90, 1.6}, 0, 50, world::kOutside));
    EXPECT_GT(pixelsOfRecord(pictures, up, mast), 40u) << "its foot is below the picture";
    EXPECT_EQ(pixelsOfRecord(pictures, up, mast) + skyPixels(up), up.ids.size());
    const Picture tip = pictures.expectClean(pictures.look({64, 120, 1.6}, 270, -10, world::kOutside));
    EXPECT_GT(pixelsOfRecord(pictures, tip, mast), 40u) << "it extends northwards from its anchor";
    const Picture east = pictures.expectClean(pictures.look({80, 90, 1.6}, 180, -5, world::kOutside));
    EXPECT_EQ(pixelsOfRecord(pictures, east, mast), 0u) << "no pixel at its unturned position";
    EXPECT_EQ(east.counts.instancesDrawn, east.counts.instancesTested - east.counts.instancesCulled);
}

TEST_P(CasesDistance, case15_aTallVillagerSeenByTheHeadAlone) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    const std::uint32_t giant = world.addModel(boxExterior({-0.4, 0, 0}, {0.4, 9, 0.8}, "coat"));
    world::MovingEntries moving;
    const Vec3 origin(world.home().x * limen::world::kBlockSize, world.home().y * limen::world::kBlockSize,
                      0.0);
    moving.routes.push_back(
        {"round",
         true,
         {{origin + Vec3(90, 100, 0), 0}, {origin + Vec3(102, 100, 0), 0}, {origin + Vec3(96, 110, 0), 0}}});
    moving.villagers.push_back({"giant", "round", giant, 1.0, 0.0, {}, {}});
    PictureWorld pictures(world, options(moving));
    pictures.fov = 40;
    std::size_t seen = 0;
    for (double seconds = 0; seconds < 32; seconds += 2.9) {
        SCOPED_TRACE(seconds);
        const frame::FrameView frame = pictures.look({96, 92, 2.6}, 0, -4, world::kOutside);
        pictures.setDynamics(dynamicsFor(frame, seconds, {}));
        seen += pixelsOfRecord(pictures, pictures.expectClean(frame), giant);
    }
    EXPECT_GT(seen, 300u);
}

} // namespace
} // namespace limen::test
