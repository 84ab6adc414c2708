#include "picture/MechanismScenes.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace limen::test {
namespace {

/// Two houses on a meadow, one behind the other, each with one room, a door, and a window in line with it.
NamedView twoHouses() {
    NamedView view;
    view.world.setFlatTerrain(view.world.home(), 0);
    const auto house = [&](double south, double north, double door, double back, const std::string& colour) {
        const auto cell = view.world.addBox({90, south, 0}, {96, north, 3}, colour);
        const auto exit = view.world.openOutside(cell, rectangle({92, door, 0.1}, {93.2, door, 2.1}));
        const auto window = view.world.openOutside(cell, rectangle({92, back, 1}, {93.2, back, 2}));
        view.world.addBuilding(boxExterior({90, south, 0}, {96, north, 3}), {exit, window});
    };
    house(80, 86, 86, 80, "brown");
    house(100, 106, 100, 106, "blue");
    return view;
}

/// Two rooms, 4 × 4 × 3 m, joined by a door 1 m wide and 2 m high in the plane x = 4.
NamedView twoRooms() {
    NamedView view;
    const auto west = view.world.addBox({0, 0, 10}, {4, 4, 13}, "brown");
    const auto east = view.world.addBox({4, 0, 10}, {8, 4, 13}, "blue");
    view.world.link(west, rectangle({4, 1.5, 10}, {4, 2.5, 12}), east);
    view.root = west;
    return view;
}

} // namespace

NamedView houseFromTheYard() {
    NamedView view = twoHouses();
    view.eye = {92.6, 94, 1.2};
    return view;
}

NamedView hillBeforeTheTunnel() {
    NamedView view;
    view.world.setFlatTerrain(view.world.home(), 0);
    for (int x = 3; x <= 5; ++x) // a hill 8 m high across the middle of the block
        for (int y = 0; y <= 8; ++y)
            view.world.terrain(view.world.home()).heights[static_cast<std::size_t>(x * 9 + y)] = 4;
    const auto tunnel = view.world.addBox({50, 90, 0}, {142, 94, 3}, "brown");
    const auto west = view.world.openOutside(tunnel, rectangle({50, 90.5, 0.2}, {50, 93.5, 2.8}));
    const auto east = view.world.openOutside(tunnel, rectangle({142, 90.5, 0.2}, {142, 93.5, 2.8}));
    view.world.addBuilding(boxExterior({50, 90, 0}, {142, 94, 3}), {west, east});
    view.eye = {40, 92, 1.5};
    view.yaw = 90;
    view.fov = 20;
    return view;
}

NamedView hallBesideAWindow() {
    NamedView view;
    TestWorld& world = view.world;
    const auto room = world.addBox({0, 0, 0}, {8, 4, 3}, "brown");
    const auto hall = world.addBox({0, 4, 0}, {20, 8, 3}, "blue");
    const auto closet = world.addBox({4, 4, 0}, {8, 6, 3}, "red"); // at the hall's position
    const auto beyond = world.addBox({0, 8, 0}, {20, 12, 3}, "green");
    world.link(room, rectangle({5, 4, 0.5}, {7, 4, 2.5}), closet);
    world.link(room, rectangle({1, 4, 0.5}, {3, 4, 2.5}), hall);
    world.link(hall, rectangle({1, 8, 0.2}, {19, 8, 2.8}), beyond);
    view.root = room;
    view.eye = {2, 0.5, 1.5};
    view.yaw = 30;
    return view;
}

NamedView roundOpeningsInARow() {
    NamedView view;
    TestWorld& world = view.world;
    const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
    const auto c = world.addBox({0, 8, 0}, {4, 12, 3}, "red");
    world.link(a, regularPolygon({2, 4, 1.5}, {0, -1, 0}, 0.9, 12), b);
    world.link(b, rectangle({0.2, 8, 0.2}, {3.8, 8, 2.8}), c);
    view.root = a;
    view.eye = {2.621, 2.366, 1.247};
    view.yaw = 1.091;
    view.pitch = 1.21;
    return view;
}

NamedView noseInTheDoorway() {
    NamedView view = twoRooms();
    view.eye = {3.9995, 1.7, 11.5};
    view.yaw = 80;
    view.pitch = -10;
    return view;
}

NamedView lintelOfAGate() {
    NamedView view;
    const auto west = view.world.addBox({0, 0, 0}, {40, 140, 50}, "brown");
    const auto east = view.world.addBox({40, 0, 0}, {80, 140, 50}, "blue");
    view.world.link(west, rectangle({40, 10, 1}, {40, 130, 41}), east);
    view.root = west;
    view.eye = {39.999686671427568, 48.658, 40.999981984688752};
    view.yaw = 23.238;
    view.pitch = -37.291;
    return view;
}

NamedView eyeInTheDoorsPlane() {
    NamedView view = twoRooms();
    view.eye = {4, 2, 11};
    view.yaw = 45;
    return view;
}

NamedView doorBehindAWindow() {
    NamedView view;
    TestWorld& world = view.world;
    world.setFlatTerrain(world.home(), 0);
    const auto near = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
    const auto window = world.openOutside(near, rectangle({92, 80, 1}, {93.2, 80, 2}));
    world.addBuilding(boxExterior({90, 80, 0}, {96, 86, 3}), {window});
    const auto far = world.addBox({90, 100, 0}, {96, 106, 3}, "blue");
    const auto door = world.openOutside(far, rectangle({92, 100, 0.1}, {93.2, 100, 2.1}));
    world.addBuilding(boxExterior({90, 100, 0}, {96, 106, 3}), {door});
    view.eye = {92.6, 74, 1.6};
    view.fov = 30;
    return view;
}

NamedView someoneInADoorway() {
    NamedView view = twoHouses();
    view.root = 1;
    view.eye = {93.4, 103, 1.6};
    view.yaw = 190;
    view.world.addObject(view.world.addModel(boxExterior({-0.3, -0.3, 0}, {0.3, 0.3, 1.8}, "pink")),
                         frameAt({92.6, 100.0, 0.1}, 30));
    return view;
}

NamedView shutDoor() {
    NamedView view = twoRooms();
    const std::uint32_t leaf = view.world.addModel(boxExterior({-0.03, 0, 0}, {0.03, 1, 2}, "wood"));
    const Vec3 origin(view.world.home().x * 192.0, view.world.home().y * 192.0, 0.0);
    view.moving.doors.push_back(
        {"door", view.world.id(*view.root), 0, true, 0.0, {{leaf, origin + Vec3(4, 1.5, 10), 0.0, 90.0}}});
    view.doors = 0.0;
    view.eye = {1, 2, 11.5};
    view.yaw = 90;
    return view;
}

NamedView boardThroughAShutDoor() {
    NamedView view;
    TestWorld& world = view.world;
    world.setFlatTerrain(world.home(), 0);
    const auto room = world.addBox({90, 80, 0}, {94, 84, 3}, "brown");
    const auto next = world.addBox({94, 80, 0}, {98, 84, 3}, "blue");
    world.link(room, rectangle({94, 81, 0}, {94, 82.5, 2}), next);
    const auto window = world.openOutside(room, rectangle({92.5, 84, 0.5}, {93.5, 84, 2}));
    const auto other = world.openOutside(next, rectangle({94.1, 84, 0.5}, {96, 84, 2}));
    world.addBuilding(boxExterior({90, 80, 0}, {98, 84, 3}), {window, other});
    world.addStatic(next, world.addModel(boxExterior({-0.00015, -0.5, -0.9}, {0.1, 1.9, 0.9}, "red")),
                    frameAt({94, 82, 1.2})); // also a member of the first room, through both windows
    view.moving.doors.push_back({"door", world.id(room), 0, true, 0.0, {}});
    view.doors = 0.0;
    view.root = room;
    view.eye = {92.5, 81.5, 1.4};
    view.yaw = 45;
    return view;
}

NamedView twoWindowsOnAMeadow() {
    NamedView view;
    TestWorld& world = view.world;
    world.setFlatTerrain(world.home(), 0);
    const auto room = world.addBox({90, 80, 0}, {98, 86, 3}, "brown");
    const auto left = world.openOutside(room, rectangle({91, 86, 0.5}, {93, 86, 2.5}));
    const auto right = world.openOutside(room, rectangle({95, 86, 0.5}, {97, 86, 2.5}));
    world.addBuilding(boxExterior({90, 80, 0}, {98, 86, 3}), {left, right});
    const std::uint32_t tree = world.addModel(boxExterior({-0.8, -0.8, 0}, {0.8, 0.8, 4}, "green"));
    world.addObject(tree, frameAt({88, 95, 0}));
    world.addObject(tree, frameAt({100, 95, 0}));
    view.root = room;
    view.eye = {94, 82, 1.5};
    return view;
}

NamedView boardsBehindAPanel() {
    NamedView view;
    TestWorld& world = view.world;
    const auto room = world.addBox({0, 0, 0}, {8, 12, 4}, "grey");
    world.addStatic(room, world.addModel(boxExterior({0, 0, 0}, {6, 0.02, 3}, "oak")),
                    frameAt({1, 5.9, 0.2}));
    for (int i = 0; i < 5; ++i) {
        const double z = 1 + i * 0.25;
        world.addStatic(room, world.addModel(boxExterior({0, 0, 0}, {5, 2, 0.02}, "pine")),
                        frameAt({1.5, 5.95, z - 0.02}));
    }
    view.root = room;
    view.eye = {4.512, 2.759, 1.50030269134281};
    view.yaw = 6.813;
    view.pitch = -12.839137610360035;
    return view;
}

NamedView eavesBehindAnEdge() {
    NamedView view;
    TestWorld& world = view.world;
    const auto hall = world.addBox({0, 0, 0}, {100, 120, 40}, "grey");
    const Wall front{{{-30, 0, -7}, {30, 0, -7}, {30, 0, 0}, {-30, 0, 0}}, "pine"};
    const Wall eaves{{{-30, 0, 0}, {-30, 6, 0}, {30, 6, 0}, {30, 0, 0}}, "oak"};
    world.addStatic(hall, world.addModel({front, eaves}), frameAt({50, 60, 9}));
    view.root = hall;
    view.eye = {50, 10, 4};
    // The edge, 50 m away and 5 m up, passes through the centres of a row of pixels, 4.5 above the middle of
    // the picture.
    const double perPixel = std::tan(glm::radians(view.fov / 2)) / (view.height / 2.0);
    view.pitch = glm::degrees(std::atan(5.0 / 50.0) - std::atan(4.5 * perPixel));
    return view;
}

NamedView landingsInAShaft() {
    NamedView view;
    TestWorld& world = view.world;
    const auto shaft = world.addBox({0, 40, 0}, {12, 60, 30}, "grey");
    for (int i = 0; i < 6; ++i) { // each ends at the same diagonal, with corners of its own
        const double one = 1.703125 + 0.359375 * i, other = 2.296875 + 0.203125 * i,
                     z = 19.71875 - 1.640625 * i;
        world.walls(shaft).push_back({{{5 - one, 50 + one, z}, {5 + other, 50 - other, z}, {11, 56, z}},
                                      i == 0   ? "pine"
                                      : i == 1 ? "oak"
                                               : "brown"});
    }
    view.root = shaft;
    view.eye = {5.23456781, 49.76543219, 20.006579};
    view.pitch = -90.0;
    return view;
}

NamedView stepFromAbove() {
    NamedView view;
    TestWorld& world = view.world;
    constexpr double kStep = 8.71875, kTop = 40.0; // metres
    const Vec3 along(0.8, -0.6, 0), across(0.6, 0.8, 0), middle(10, 50, 0);
    // From above: the corners of the hall, with the ends of the step among them.
    const Vec3 west = middle - along * 31.7, east = middle + along * 29.3, south = middle - across * 40.0,
               north = middle + across * 40.0;
    const Vec3 up(0, 0, kStep), top(0, 0, kTop);
    test::Walls walls{{{south + up, east + up, west + up}, "pine"},
                      {{east, north, west}, "grey"},
                      {{west, west + up, east + up, east}, "oak"},
                      {{south + top, west + top, north + top, east + top}, "grey"},
                      {{south + up, west + up, west + top, south + top}, "grey"},
                      {{east + up, south + up, south + top, east + top}, "grey"},
                      {{west + up, west, north, north + top, west + top}, "grey"},
                      {{north, east, east + up, east + top, north + top}, "grey"}};
    view.root = world.addCell(walls);
    // Behind the riser, by less than floats can resolve between the edges on both sides.
    view.eye = middle - along * 4.0979 - across * 1.51e-6 + Vec3(0, 0, 27.9495);
    view.yaw = glm::degrees(std::atan2(along.x, along.y)) - 45.0;
    view.pitch = -90.0;
    return view;
}

NamedView barsInAnOpening() {
    NamedView view;
    TestWorld& world = view.world;
    const auto west = world.addBox({0, 0, 10}, {4.3, 4, 13}, "brown");
    const auto east = world.addBox({4.3, 0, 10}, {8, 4, 13}, "blue");
    world.link(west, rectangle({4.3, 1.5, 10}, {4.3, 2.5, 12}), east);
    for (int i = 0; i < 4; ++i) {
        const double y = 1.6 + 0.22 * i;
        world.walls(west).push_back({rectangle({4.3001, y, 10}, {4.3001, y + 0.1, 12}), "iron", true});
    }
    view.root = east;
    view.eye = {4.832, 1.494, 10.875};
    view.yaw = 276.946;
    view.pitch = -4.761;
    return view;
}

} // namespace limen::test
