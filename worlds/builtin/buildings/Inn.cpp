#include "worlds/builtin/buildings/Inn.h"

#include "worlds/builtin/buildings/HouseShell.h"
#include "worlds/builtin/buildings/InnProps.h"
#include "worlds/builtin/buildings/InnRooms.h"

namespace limen::worlds {

namespace {

using inn::kUpper;

Rect window(double from, double to) {
    return {from, 0.9, to, 2.1};
}
Rect upperWindow(double from, double to) {
    return {from, kUpper + 0.9, to, kUpper + 1.95};
}

HouseShell innShell() {
    HouseShell shell;
    shell.halfWidth = 8.0;
    shell.depth = 11.0;
    shell.top = 5.75;
    shell.upperFloor = 2.98;
    shell.pitch = 0.9;
    shell.ground = -0.375;
    shell.chimneyX = -7.15;
    shell.chimneyY = inn::kHearthY;
    for (const auto& [side, opening] : innDoors())
        shell.holes.push_back({side, opening, true});
    for (const auto& [side, opening] : innWindows())
        shell.holes.push_back({side, opening, false});
    return shell;
}

} // namespace

std::vector<Opening> innDoors() {
    return {{Side::South, {-0.65, 0.0, 0.65, 2.15}},
            {Side::South, {-0.6, kUpper, 0.6, kUpper + 2.1}},
            {Side::North, {1.8, 0.0, 2.8, 2.1}}};
}

std::vector<Opening> innWindows() {
    return {{Side::South, window(-6.4, -5.2)},      {Side::South, window(-3.6, -2.4)},
            {Side::South, window(3.4, 4.6)},        {Side::South, window(5.6, 6.8)},
            {Side::West, window(5.0, 6.0)},         {Side::West, window(7.9, 9.1)},
            {Side::North, window(-6.4, -5.2)},      {Side::North, window(-3.0, -1.8)},
            {Side::East, window(2.0, 3.2)},         {Side::East, window(7.4, 8.6)},
            {Side::South, upperWindow(-6.4, -5.2)}, {Side::South, upperWindow(3.4, 4.6)},
            {Side::South, upperWindow(5.6, 6.8)},   {Side::West, upperWindow(0.9, 1.9)},
            {Side::West, upperWindow(7.9, 9.1)},    {Side::North, upperWindow(-6.4, -5.2)},
            {Side::North, upperWindow(-0.6, 0.6)},  {Side::North, upperWindow(3.5, 4.1)},
            {Side::East, upperWindow(2.0, 3.2)}};
}

namespace inn {

Vec3 chimneyMouth() {
    const HouseShell shell = innShell();
    return {shell.chimneyX, shell.chimneyY, chimneyTop(shell) + 0.4};
}

Vec3 hearthFire() {
    return {-7.69 + 0.3, kHearthY, 0.25};
}

} // namespace inn

BuildingPlan planInn(ModelWriter& writer, const Furniture& furniture) {
    const HouseShell shell = innShell();
    BuildingPlan plan;
    plan.name = "inn";
    plan.exterior = buildHouseShell(shell);
    addBalcony(plan.exterior, shell.ground);
    plan.cells = planInnRooms(writer, furniture);
    return plan;
}

} // namespace limen::worlds
