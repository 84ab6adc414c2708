#include "worlds/builtin/buildings/Cottages.h"

#include "worlds/builtin/buildings/HouseShell.h"
#include "worlds/builtin/buildings/RoomParts.h"

namespace limen::worlds {

namespace {

constexpr double kCottageHeight = 2.5;
/// The hook of lanterns, below joists at x = +-0.95 and 2.85.
constexpr double kJoistUnderside = kCottageHeight - 0.17;

HouseShell cottageShell() {
    HouseShell shell;
    shell.ground = -kFloorAboveGround;
    shell.chimneyX = 5.15;
    shell.chimneyY = 2.5;
    shell.holes = {{Side::South, {-0.6, 0.0, 0.6, 2.1}, true},
                   {Side::South, {-4.1, 0.9, -2.9, 2.0}, false},
                   {Side::South, {2.9, 0.9, 4.1, 2.0}, false},
                   {Side::North, {-0.7, 0.8, 0.7, 2.0}, false},
                   {Side::East, {6.6, 0.9, 7.8, 2.0}, false}};
    return shell;
}

HouseShell neighbourShell() {
    HouseShell shell;
    shell.halfWidth = 4.0;
    shell.depth = 7.0;
    shell.pitch = 1.1;
    shell.ground = -kFloorAboveGround;
    shell.chimneyX = -3.2;
    shell.chimneyY = 2.4;
    shell.holes = {{Side::South, {-0.55, 0.0, 0.55, 2.1}, true},
                   {Side::South, {1.5, 0.9, 2.8, 2.0}, false},
                   {Side::South, {-2.8, 0.9, -1.5, 2.0}, false},
                   {Side::North, {-0.7, 0.85, 0.7, 1.95}, false}};
    return shell;
}

CellPlan frontRoom(ModelWriter& writer, const Furniture& f) {
    const Rect door{-0.6, 0.0, 0.6, 2.1};
    const Rect west{-4.1, 0.9, -2.9, 2.0};
    const Rect east{2.9, 0.9, 4.1, 2.0};
    const Rect inner{-0.8, 0.0, 0.8, 2.1};
    CellPlan cell = roomWithOpenings(
        {.name = "front",
         .min = {-5.7, 0.3, 0.0},
         .max = {5.7, 4.7, kCottageHeight},
         .floor = Material::Planks},
        {{Side::South, door}, {Side::South, west}, {Side::South, east}, {Side::North, inner}});
    const dat::RecordId trim = addTrim(writer, {{{Side::South, door}, 0.3},
                                                {{Side::South, west}, 0.3},
                                                {{Side::South, east}, 0.3},
                                                {{Side::North, inner}, 4.7}});
    cell.statics = {{trim, {}},
                    {addJoists(writer, 4.4, 11.4, 1.9), {{0.0, 2.5, kCottageHeight}, 90.0}},
                    {f.fireplace, {{5.69, 2.5, 0.0}, -90.0}},
                    {f.table, {{2.5, 2.5, 0.0}, 0.0}},
                    {f.chair, {{2.2, 3.3, 0.0}, 8.0}},
                    {f.chair, {{2.9, 1.72, 0.0}, 172.0}},
                    {f.stool, {{3.9, 3.7, 0.0}, 30.0}},
                    {f.candle, {{2.35, 2.45, 0.76}, 0.0}},
                    {f.jug, {{2.9, 2.65, 0.76}, 0.0}},
                    {f.bowl, {{2.0, 2.3, 0.76}, 0.0}},
                    {f.rug, {{-3.0, 2.3, 0.0}, 0.0}},
                    {f.bench, {{-5.4, 2.4, 0.0}, 90.0}},
                    {f.shelf, {{-2.9, 4.69, 0.0}, 0.0}},
                    {f.chest, {{-4.9, 4.3, 0.0}, 0.0}},
                    {f.lantern, {{-2.85, 2.45, kJoistUnderside}, 20.0}},
                    {f.barrel, {{1.5, 4.25, 0.0}, 40.0}}};
    return cell;
}

CellPlan rearRoom(ModelWriter& writer, const Furniture& f) {
    const Rect inner{-0.8, 0.0, 0.8, 2.1};
    const Rect north{-0.7, 0.8, 0.7, 2.0};
    const Rect east{6.6, 0.9, 7.8, 2.0};
    const Rect stairs{-1.9, kStairsTopY, -0.7, 9.5};
    CellPlan cell = roomWithOpenings(
        {.name = "rear",
         .min = {-5.7, 4.9, 0.0},
         .max = {5.7, 9.7, kCottageHeight},
         .floor = Material::Planks},
        {{Side::South, inner}, {Side::North, north}, {Side::East, east}, {Side::Floor, stairs}});
    const dat::RecordId trim = addTrim(
        writer, {{{Side::South, inner}, 4.9}, {{Side::North, north}, 9.7}, {{Side::East, east}, 5.7}});
    const dat::RecordId railing = addRailing(writer, 3.6);
    cell.statics = {{trim, {}},
                    {addJoists(writer, 4.8, 11.4, 1.9), {{0.0, 7.3, kCottageHeight}, 90.0}},
                    {railing, {{-0.64, kStairsTopY, 0.0}, 0.0}},
                    {railing, {{-1.96, kStairsTopY, 0.0}, 0.0}},
                    {f.bed, {{-4.9, 8.55, 0.0}, 0.0}},
                    {f.chest, {{-5.3, 6.3, 0.0}, 90.0}},
                    {f.rug, {{-4.0, 6.2, 0.0}, 90.0}},
                    {f.table, {{4.4, 7.2, 0.0}, 90.0}},
                    {f.chair, {{3.5, 7.1, 0.0}, 95.0}},
                    {f.stool, {{4.3, 5.7, 0.0}, 0.0}},
                    {f.candle, {{4.45, 7.7, 0.76}, 0.0}},
                    {f.bowl, {{4.35, 6.9, 0.76}, 0.0}},
                    {f.shelf, {{2.6, 4.91, 0.0}, 180.0}},
                    {f.barrel, {{5.25, 9.2, 0.0}, 0.0}},
                    {f.crate, {{2.4, 9.3, 0.0}, 5.0}},
                    {f.lantern, {{2.85, 7.3, kJoistUnderside}, 0.0}},
                    {f.lantern, {{-2.85, 7.3, kJoistUnderside}, 35.0}}};
    return cell;
}

CellPlan stairwell(ModelWriter& writer) {
    const Rect top{-1.9, kStairsTopY, -0.7, 9.5};
    const Rect side{8.55, -2.6, 9.45, -0.6};
    CellPlan cell = roomWithOpenings({.name = "stairs",
                                      .min = {-1.9, kStairsTopY, -2.6},
                                      .max = {-0.7, 9.5, 0.0},
                                      .floor = Material::Flagstones,
                                      .walls = Material::StoneWall},
                                     {{Side::Ceiling, top}, {Side::East, side}});
    cell.statics = {{addStairs(writer, {}), {{kStairsX, kStairsTopY, 0.0}, 0.0}}};
    return cell;
}

CellPlan cellar(ModelWriter& writer, const Furniture& f) {
    const Rect door{8.55, -2.6, 9.45, -0.6};
    CellPlan cell = roomWithOpenings({.name = "cellar",
                                      .min = {-0.5, 3.2, -2.6},
                                      .max = {5.2, 9.5, -0.45},
                                      .floor = Material::Flagstones,
                                      .walls = Material::StoneWall,
                                      .ceiling = Material::OldPlanks},
                                     {{Side::West, door}});
    constexpr double kFloor = -2.6;
    cell.statics = {{addTrim(writer, {{{Side::West, door}, -0.5}}), {}},
                    {addJoists(writer, 5.7, 6.3, 1.3), {{2.35, 6.35, -0.45}, 0.0}},
                    {f.barrel, {{4.75, 3.75, kFloor}, 0.0}},
                    {f.barrel, {{4.75, 4.6, kFloor}, 70.0}},
                    {f.barrel, {{3.9, 3.75, kFloor}, 130.0}},
                    {f.barrel, {{4.75, 5.45, kFloor}, 200.0}},
                    {f.crate, {{0.2, 3.7, kFloor}, 4.0}},
                    {f.crate, {{1.15, 3.65, kFloor}, -6.0}},
                    {f.crate, {{0.6, 3.66, kFloor + 0.58}, 15.0}},
                    {f.candle, {{0.66, 3.62, kFloor + 1.16}, 0.0}},
                    {f.sacks, {{2.6, 3.95, kFloor}, 0.0}},
                    {f.shelf, {{2.6, 9.49, kFloor}, 0.0}},
                    {f.crate, {{4.7, 8.9, kFloor}, 90.0}},
                    {f.candle, {{4.7, 8.9, kFloor + 0.58}, 0.0}},
                    {f.lantern, {{2.2, 5.5625, -0.62}, 0.0}},
                    {f.lantern, {{4.1, 7.1375, -0.62}, 50.0}}};
    return cell;
}

} // namespace

BuildingPlan planCottage(ModelWriter& writer, const Furniture& furniture) {
    BuildingPlan plan;
    plan.name = "cottage";
    plan.exterior = buildHouseShell(cottageShell());
    plan.cells.push_back(frontRoom(writer, furniture));
    plan.cells.push_back(
        doorway("doorway", {-0.8, 4.7, 0.0}, {0.8, 4.9, 2.1}, Axis::Y, Material::Beam, Material::Oak));
    plan.cells.push_back(rearRoom(writer, furniture));
    plan.cells.push_back(stairwell(writer));
    plan.cells.push_back(doorway("cellar.doorway", {-0.7, 8.55, -2.6}, {-0.5, 9.45, -0.6}, Axis::X,
                                 Material::StoneWall, Material::Flagstones));
    plan.cells.push_back(cellar(writer, furniture));
    return plan;
}

BuildingPlan planNeighbour(ModelWriter& writer, const Furniture& f) {
    const HouseShell shell = neighbourShell();
    const Rect inner{-0.6, 0.0, 0.6, 2.1};
    BuildingPlan plan;
    plan.name = "neighbour";
    plan.exterior = buildHouseShell(shell);
    std::vector<Opening> openings;
    std::vector<WallOpening> trims;
    for (std::size_t k = 0; k < 3; ++k) {
        openings.push_back({shell.holes[k].side, shell.holes[k].rect});
        trims.push_back({openings.back(), 0.3});
    }
    openings.push_back({Side::North, inner});
    trims.push_back({openings.back(), 4.4});
    CellPlan room = roomWithOpenings({.name = "room",
                                      .min = {-3.7, 0.3, 0.0},
                                      .max = {3.7, 4.4, kCottageHeight},
                                      .floor = Material::Flagstones},
                                     openings);
    room.statics = {{addTrim(writer, trims), {}},
                    {addJoists(writer, 4.1, 7.4, 1.8), {{0.0, 2.35, kCottageHeight}, 90.0}},
                    {f.fireplace, {{-3.69, 2.4, 0.0}, 90.0}},
                    {f.table, {{2.2, 2.4, 0.0}, 90.0}},
                    {f.chair, {{1.4, 2.5, 0.0}, 85.0}},
                    {f.chair, {{3.0, 2.2, 0.0}, -92.0}},
                    {f.candle, {{2.2, 2.5, 0.76}, 0.0}},
                    {f.jug, {{2.35, 2.0, 0.76}, 0.0}},
                    {f.shelf, {{2.4, 4.39, 0.0}, 0.0}},
                    {f.rug, {{-1.3, 2.2, 0.0}, 90.0}},
                    {f.barrel, {{-1.3, 4.0, 0.0}, 0.0}}};
    plan.cells.push_back(std::move(room));
    plan.cells.push_back(
        doorway("doorway", {-0.6, 4.4, 0.0}, {0.6, 4.6, 2.1}, Axis::Y, Material::Beam, Material::Oak));
    const Rect window = shell.holes[3].rect;
    CellPlan back = roomWithOpenings({.name = "back",
                                      .min = {-3.7, 4.6, 0.0},
                                      .max = {3.7, 6.7, kCottageHeight},
                                      .floor = Material::Planks},
                                     {{Side::South, inner}, {Side::North, window}});
    back.statics = {{addTrim(writer, {{{Side::South, inner}, 4.6}, {{Side::North, window}, 6.7}}), {}},
                    {f.bed, {{-2.4, 5.9, 0.0}, 90.0}},
                    {f.chest, {{2.6, 6.35, 0.0}, 0.0}},
                    {f.stool, {{1.4, 6.2, 0.0}, 0.0}},
                    {f.lantern, {{1.6, 5.3, kCottageHeight}, 0.0}}};
    plan.cells.push_back(std::move(back));
    return plan;
}

} // namespace limen::worlds
