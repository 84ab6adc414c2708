// Hard case 4 of docs/cases.md: horizontal portals, with the eye just above and just below them, and on the
// way up.
#include "picture/CaseHelp.h"

#include "motion/Locate.h"

#include <cmath>
#include <numbers>

namespace limen::test {
namespace {

struct CasesClimbing : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesClimbing);

/// A tower of four rooms, 6 × 6 × 3 m each. Every floor has an opening a quarter turn on from the one below.
/// A spiral of steps runs around a newel that passes through all floors; the top has a window.
struct Tower {
    static constexpr int kFloors = 4;
    static constexpr double kHeight = 3.0, kLeft = 90.0, kLow = 90.0, kWide = 2.6;
    TestWorld world;
    std::vector<TestWorld::Cell> rooms;
    std::uint32_t step = world.addModel(boxExterior({-0.5, -0.25, -0.15}, {0.5, 0.25, 0}, "oak"));

    Tower() {
        world.setFlatTerrain(world.home(), 0);
        const char* colours[kFloors] = {"brown", "blue", "red", "green"};
        for (int i = 0; i < kFloors; ++i) {
            rooms.push_back(
                world.addBox({kLeft, kLow, floorOf(i)}, {kLeft + 6, kLow + 6, floorOf(i + 1)}, colours[i]));
        }
        for (int i = 1; i < kFloors; ++i) {
            const Vec3 low = openingOf(i);
            world.link(rooms[static_cast<std::size_t>(i - 1)], rectangle(low, low + Vec3(kWide, kWide, 0)),
                       rooms[static_cast<std::size_t>(i)]);
        }
        for (int k = 0; k < 48; ++k) { // a dozen steps are a quarter turn and 3 m
            const Vec3 at = spiral(k / 12.0);
            const int room = static_cast<int>(at.z / kHeight);
            if (std::abs(at.z - std::round(at.z / kHeight) * kHeight) > 0.2) {
                world.addStatic(rooms[static_cast<std::size_t>(std::min(room, kFloors - 1))], step,
                                frameAt(at, 90.0 * k / 12.0 + 45.0));
            }
        }
        const auto window = world.openOutside(
            rooms.back(), rectangle({kLeft, kLow + 2, floorOf(3) + 1}, {kLeft, kLow + 4, floorOf(3) + 2}));
        const auto door =
            world.openOutside(rooms[0], rectangle({kLeft, kLow + 2, 0.1}, {kLeft, kLow + 3, 2.1}));
        world.addBuilding(boxExterior({kLeft, kLow, 0}, {kLeft + 6, kLow + 6, floorOf(kFloors)}),
                          {window, door});
    }
    [[nodiscard]] static double floorOf(int i) { return kHeight * i; }
    /// The south-western corner of the opening in floor `i` (1..).
    [[nodiscard]] static Vec3 openingOf(int i) {
        const Vec3 middle = spiral(i - 0.27); // from the height of the head to that of the feet
        return {middle.x - kWide / 2, middle.y - kWide / 2, floorOf(i)};
    }
    /// Position on the stairs after a number of floors.
    [[nodiscard]] static Vec3 spiral(double floors) {
        const double angle = (floors + 0.5) * std::numbers::pi / 2;
        return {kLeft + 3 + 1.6 * std::cos(angle), kLow + 3 + 1.6 * std::sin(angle), floors * kHeight};
    }
};

TEST_P(CasesClimbing, case04_millimetresAboveAndBelowAHorizontalPortal) {
    Tower tower;
    PictureWorld pictures(tower.world, options());
    pictures.width = 64;
    pictures.height = 48;
    for (int floor = 1; floor < Tower::kFloors; ++floor) {
        const Vec3 middle = Tower::openingOf(floor) + Vec3(1.3, 1.3, 0);
        for (const Vec3& aside :
             {Vec3(0.03, -0.21, 0), Vec3(1.293, 0.4, 0)}) { // the middle, and near an edge
            world::SpaceIndex space =
                pictures.space(tower.world.id(tower.rooms[static_cast<std::size_t>(floor - 1)]));
            Vec3 last = middle + aside - Vec3(0, 0, 0.011);
            for (int step = 0; step <= 20; ++step) {
                const Vec3 eye = middle + aside + Vec3(0, 0, -0.0101 + 0.001 * step);
                space = motion::sweep(pictures.world(), space, pictures.homeOrigin() + last,
                                      pictures.homeOrigin() + eye);
                last = eye;
                SCOPED_TRACE(::testing::Message() << "floor " << floor << ", step " << step);
                const double pitches[] = {-75, 0, 70, 25, -35};
                const Picture picture =
                    pictures.expectClean(pictures.look(eye, 67.0 * step, pitches[step % 5], space));
                EXPECT_LT(picture.visible.visits.size(), 16u) << "no ping-pong";
            }
            EXPECT_EQ(space, pictures.space(tower.world.id(tower.rooms[static_cast<std::size_t>(floor)])));
        }
    }
}

TEST_P(CasesClimbing, case04_exactlyInAHorizontalPortalsPlane) {
    Tower tower;
    PictureWorld pictures(tower.world, options());
    const Vec3 eye = Tower::openingOf(2) + Vec3(1.1, 0.8, 0);
    for (const std::size_t room : {1u, 2u}) {
        for (const double pitch : {-80.0, -30.0, 0.0, 30.0, 80.0}) {
            SCOPED_TRACE(::testing::Message() << "room " << room << ", pitch " << pitch);
            pictures.expectClean(
                pictures.look(eye, 20 + pitch, pitch, pictures.space(tower.world.id(tower.rooms[room]))));
        }
    }
}

TEST_P(CasesClimbing, case04_upATowersSpiralAndDownAgain) {
    Tower tower;
    PictureWorld pictures(tower.world, options());
    pictures.width = 64;
    pictures.height = 48;
    std::size_t stairs = 0, below = 0;
    for (const bool down : {false, true}) {
        const auto eyeAt = [&](int step) {
            const double floors = (down ? 60 - step : step) / 60.0 * 3.1;
            return Tower::spiral(floors) + Vec3(0, 0, 1.633);
        };
        world::SpaceIndex space = motion::locate(pictures.world(), pictures.homeOrigin() + eyeAt(0)).space;
        for (int step = 0; step <= 60; ++step) {
            const Vec3 eye = eyeAt(step);
            space =
                motion::sweep(pictures.world(), space, pictures.homeOrigin() + eyeAt(std::max(step - 1, 0)),
                              pictures.homeOrigin() + eye);
            SCOPED_TRACE(::testing::Message() << "step " << step << (down ? " down" : " up"));
            const double yaw = (down ? 90.0 : -90.0) * step / 20.0; // with the spiral, or against it
            const Picture picture = pictures.expectClean(pictures.look(eye, yaw, -50, space));
            stairs += pixelsOfRecord(pictures, picture, tower.step);
            below += space != pictures.space(tower.world.id(tower.rooms[0])) &&
                     seesSpace(picture, pictures.space(tower.world.id(tower.rooms[0])));
        }
        EXPECT_EQ(space, pictures.space(tower.world.id(down ? tower.rooms[0] : tower.rooms[3])));
    }
    EXPECT_GT(stairs, 5000u) << "the flight is in the pictures";
    EXPECT_GT(below, 5u) << "and the lowest floor beneath it, from above";
}

} // namespace
} // namespace limen::test
