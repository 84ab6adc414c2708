// Hard case 43 of docs/cases.md: eyes at the planes, edges and corners of openings, a micrometre to a centimetre off.
#include "picture/CaseHelp.h"

namespace limen::test {
namespace {

struct Straddle : ZoneCases {};
LIMEN_BOTH_ZONINGS(Straddle);

/// A house of two rooms with a door between them, a door to the outside and a window.
struct House {
    TestWorld world;
    TestWorld::Cell room = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
    TestWorld::Cell closet = world.addBox({96, 80, 0}, {99, 86, 3}, "blue");
    TestWorld::Portal door, window;
    House() {
        world.setFlatTerrain(world.home(), 0);
        world.link(room, rectangle({96, 84, 0}, {96, 85.2, 2.1}), closet);
        door = world.openOutside(room, rectangle({94, 86, 0.1}, {95.4, 86, 2.1}));
        window = world.openOutside(closet, rectangle({97, 86, 1}, {98, 86, 2}));
        world.addBuilding(boxExterior({90, 80, 0}, {99, 86, 3}), {door, window});
    }
};

/// An opening in a plane of constant x or y.
struct Opening {
    Vec3 corner{0.0}, right{0.0}, up{0.0}; ///< a corner, and both sides from there
    Vec3 out{0.0};                         ///< away from `here`
    world::SpaceIndex here = 0, there = 0;
};

constexpr double kOff[] = {1e-6, 9e-6, 3e-5, 1.1e-4, 1.9e-4, 3e-4, 2e-3, 1e-2};

/// Draws from points of an opening's plane, and `off` before and behind it.
void lookFromAround(PictureWorld& pictures, const Opening& opening, const Vec3& point) {
    const Vec3 along = glm::normalize(opening.right), up = glm::normalize(opening.up);
    for (const double off : kOff) {
        for (const double side : {-1.0, 1.0}) {
            const Vec3 eye = point + opening.out * (side * off);
            for (const Vec3& gaze :
                 {along, -along, along + opening.out * 0.01, up + opening.out * 0.3 + along * 0.1,
                  -up - opening.out * 0.2 - along * 0.1}) {
                const double yaw = glm::degrees(std::atan2(gaze.x, gaze.y));
                const double pitch = glm::degrees(std::atan2(gaze.z, std::hypot(gaze.x, gaze.y)));
                // Up to the tolerance past the plane, either space may be said to be the eye's.
                for (const world::SpaceIndex root : {opening.here, opening.there}) {
                    const double past = root == opening.here ? side * off : -side * off;
                    if (past > kInPlaneTolerance)
                        continue;
                    SCOPED_TRACE(::testing::Message()
                                 << "at " << point.x << " " << point.y << " " << point.z << ", " << side * off
                                 << " m, root " << root << ", yaw " << yaw << ", pitch " << pitch);
                    pictures.expectClean(pictures.look(eye, yaw, pitch, root));
                }
            }
        }
    }
}

void lookFromAll(PictureWorld& pictures, const Opening& opening) {
    const Vec3 along = glm::normalize(opening.right), up = glm::normalize(opening.up);
    const Vec3 middle = opening.corner + 0.5 * opening.right + 0.5 * opening.up;
    for (const double in : {1e-5, 1.5e-4, 5e-4, 5e-3}) {
        lookFromAround(pictures, opening, opening.corner + 0.4 * opening.up + in * along);
        lookFromAround(pictures, opening, opening.corner + in * (along + up));
    }
    lookFromAround(pictures, opening, middle);
}

TEST_P(Straddle, case44_aroundADoorBetweenRooms) {
    House house;
    PictureWorld pictures(house.world, options());
    pictures.width = 48;
    pictures.height = 32;
    lookFromAll(pictures, {{96, 84, 0},
                           {0, 1.2, 0},
                           {0, 0, 2.1},
                           {1, 0, 0},
                           pictures.space(house.world.id(house.room)),
                           pictures.space(house.world.id(house.closet))});
}

TEST_P(Straddle, case44_aroundADoorToTheOutside) {
    House house;
    PictureWorld pictures(house.world, options());
    pictures.width = 48;
    pictures.height = 32;
    lookFromAll(pictures, {{94, 86, 0.1},
                           {1.4, 0, 0},
                           {0, 0, 2.0},
                           {0, 1, 0},
                           pictures.space(house.world.id(house.room)),
                           world::kOutside});
}
} // namespace
} // namespace limen::test
