// Hard case 43 of docs/cases.md: doors of a world database.
#include "picture/CaseHelp.h"
#include "support/PlacedHut.h"

namespace limen::test {
namespace {

struct CasesPlaced : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesPlaced);

struct DoorEye {
    Vec3 eye;
    double yaw;
    bool isInside;
};
const std::array<DoorEye, 5> kEyes{{{{6.5, 11.4, 3.4}, 90, false},
                                    {{9.4, 11.5, 3.6}, 90, false},
                                    {{8.6, 9.2, 3.4}, 40, false},
                                    {{12.6, 12.9, 3.4}, 235, true},
                                    {{11.5, 11.6, 3.4}, 90, true}}};

/// Draws the hut from all eyes with its doors shut, opening and open.
void expectCleanDoors(PlacedHut& placed, const PictureOptions& options, bool shutsTheView) {
    PictureWorld pictures(placed.hut.source, options);
    pictures.width = 96;
    pictures.height = 64;
    const world::SpaceIndex front = pictures.space(placed.hut.source.id(placed.hut.front));
    for (const double doors : {0.0, 0.004, 0.35, 0.5, 1.0}) {
        for (const DoorEye& eye : kEyes) {
            SCOPED_TRACE(::testing::Message()
                         << "doors " << doors << ", eye " << eye.eye.x << " " << eye.eye.y);
            const frame::FrameView frame =
                pictures.look(eye.eye, eye.yaw, -4, eye.isInside ? front : world::kOutside);
            pictures.setDynamics(dynamicsFor(frame, 1.0, doors));
            const Picture picture = pictures.expectClean(frame);
            if (!eye.isInside)
                EXPECT_EQ(visitsSpace(picture, front), doors > 0.0 || !shutsTheView);
        }
    }
}

TEST_P(CasesPlaced, case43_doorsOfADatabaseAreFillings) {
    PlacedHut placed;
    placed.placeDoors();
    expectCleanDoors(placed, options(placed.hut.moving), true);
}

TEST_P(CasesPlaced, case43_aDoorBesideItsOpeningHangsInIt) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed[0].position.x -= 0.12;
    placed.hut.moving.placed[1].position.x += 0.3;
    expectCleanDoors(placed, options(placed.hut.moving), true);
}

TEST_P(CasesPlaced, case43_barsAndADoorWithoutAnOpening) {
    PlacedHut placed;
    placed.placeDoors();
    Walls bars;
    for (int i = 0; i < 5; ++i)
        for (auto& wall : boxExterior({-0.03, 0.2 * i, 0}, {0.03, 0.2 * i + 0.05, 2}, "iron"))
            bars.push_back(wall);
    placed.hut.moving.placed[0].model = placed.hut.source.addModel(bars);
    placed.hut.moving.placed.push_back(placed.door(3, {7.5, 10.5, 2}, placed.clockwise));
    expectCleanDoors(placed, options(placed.hut.moving), false);
}

TEST_P(CasesPlaced, case43_thingsOfADatabaseBelongToTheSpacesThatTheyReach) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed.push_back(placed.thing(
        9, placed.hut.table, placed.hut.source.id(placed.hut.front), {10.6, 11.5, 2})); // through the door
    placed.hut.moving.placed.push_back(placed.thing(10, placed.hut.body, 0, {8.5, 11.5, 2}));
    placed.hut.moving.placed.back().opacity = 0.5;
    expectCleanDoors(placed, options(placed.hut.moving), true);
}

} // namespace
} // namespace limen::test
