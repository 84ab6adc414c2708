#include "worlds/builtin/buildings/MeetingHall.h"

#include "worlds/builtin/buildings/HouseShell.h"
#include "worlds/builtin/buildings/RoomParts.h"
#include "worlds/records/Seams.h"
#include "worlds/shapes/ArchWall.h"

namespace limen::worlds {

namespace {

using namespace hall;

constexpr double kWallTop = 3.875; ///< of the nave's long walls, inside
constexpr double kApseHeight = 4.375;
constexpr double kApseSouth = 2.375, kApseNorth = 7.25;
/// Metres by which the apse's exterior is lower, so that no two stones of apse and nave are in one plane.
constexpr double kApseLower = 1.0 / 128.0;
constexpr double kArchRadius = 1.875, kSpringing = 2.125;
constexpr int kArchSegments = 12;
constexpr Rect kDoor{kMiddle - 1.4375, 0.0, kMiddle + 1.4375, 2.875};
constexpr Rect kApseWindow{kMiddle - 0.5, 1.5, kMiddle + 0.5, 3.375};

HoleTop arch() {
    return archTop(kMiddle, kArchRadius, kSpringing, kArchSegments);
}

std::vector<Opening> naveWindows() {
    std::vector<Opening> out;
    for (const Side side : {Side::South, Side::North})
        for (const double x : {-3.75, 0.0, 3.75})
            out.push_back({side, {x - 0.5, 1.375, x + 0.5, 3.25}});
    return out;
}

HouseShell naveShell() {
    HouseShell shell;
    shell.halfWidth = kHalfLength;
    shell.depth = kWidth;
    shell.wall = kWall;
    shell.top = 4.25;
    shell.ground = -0.375;
    shell.walls = Material::StoneWall;
    shell.timbered = false;
    shell.chimney = false;
    shell.holes.push_back({Side::West, kDoor, true});
    for (const auto& [side, rect] : naveWindows())
        shell.holes.push_back({side, rect, false});
    return shell;
}

/// Begins inside the nave's wall; its x = 0 is the middle.
HouseShell apseShell() {
    HouseShell shell;
    shell.halfWidth = 0.5 * (kApseEast + kWall - 6.25);
    shell.depth = kApseNorth - kApseSouth + 2.0 * kWall;
    shell.wall = kWall;
    shell.top = 4.625;
    shell.pitch = 0.8;
    shell.ground = -0.375;
    shell.walls = Material::StoneWall;
    shell.timbered = false;
    shell.chimney = false;
    Rect window = kApseWindow;
    window.u0 -= kApseSouth - kWall;
    window.u1 -= kApseSouth - kWall;
    window.v0 += kApseLower;
    window.v1 += kApseLower;
    shell.holes.push_back({Side::East, window, false});
    return shell;
}

/// The nave: walls, end walls up to the roof, two slopes as a ceiling.
CellPlan nave(ModelWriter& writer) {
    constexpr double kSouth = kWall;
    constexpr double kNorth = kWidth - kWall;
    constexpr double kRidge = kWallTop + (kMiddle - kSouth); // the roof has a slope of 1
    CellPlan cell;
    cell.name = "nave";
    const std::vector<Opening> windows = naveWindows();
    for (const Side side : {Side::South, Side::North}) {
        std::vector<Rect> holes;
        for (const Opening& o : windows)
            if (o.side == side)
                holes.push_back(o.rect);
        const double at = side == Side::South ? kSouth : kNorth;
        for (const Rect& r : withoutHoles({-kInnerEnd, 0.0, kInnerEnd, kWallTop}, holes))
            cell.faces.push_back(planarFace(rectOnSide(side, at, r), Material::InnerPlaster));
    }
    cell.faces.push_back(planarFace(rectOnSide(Side::Floor, 0.0, {-kInnerEnd, kSouth, kInnerEnd, kNorth}),
                                    Material::Flagstones));
    cell.faces.push_back(planarFace({{-kInnerEnd, kMiddle, kRidge},
                                     {kInnerEnd, kMiddle, kRidge},
                                     {kInnerEnd, kSouth, kWallTop},
                                     {-kInnerEnd, kSouth, kWallTop}},
                                    Material::OldPlanks));
    cell.faces.push_back(planarFace({{kInnerEnd, kMiddle, kRidge},
                                     {-kInnerEnd, kMiddle, kRidge},
                                     {-kInnerEnd, kNorth, kWallTop},
                                     {kInnerEnd, kNorth, kWallTop}},
                                    Material::OldPlanks));
    const std::vector<Vec2> gable{{kSouth, kWallTop}, {kMiddle, kRidge}, {kNorth, kWallTop}};
    const ArchWall west{Side::West, -kInnerEnd, 0.0, gable, rectangleTop(kDoor), Material::InnerPlaster};
    const ArchWall east{Side::East, kInnerEnd, 0.0, gable, arch(), Material::InnerPlaster};
    for (const ArchWall* wall : {&west, &east})
        for (Face& face : wallFaces(*wall))
            cell.faces.push_back(std::move(face));
    cell.faces.push_back(holePortal(west));
    cell.faces.push_back(holePortal(east));
    std::vector<WallOpening> framed{{{Side::West, kDoor}, -kInnerEnd}};
    for (const Opening& o : windows) {
        const double at = o.side == Side::South ? kSouth : kNorth;
        cell.faces.push_back(portalFace(rectOnSide(o.side, at, o.rect)));
        framed.push_back({o, at});
    }
    closeSeams(cell.faces);
    cell.statics.push_back({addTrim(writer, framed), {}});
    return cell;
}

CellPlan apse(ModelWriter& writer) {
    CellPlan cell;
    cell.name = "apse";
    const Rect plan{kApseWest, kApseSouth, kApseEast, kApseNorth};
    cell.faces.push_back(planarFace(rectOnSide(Side::Floor, 0.0, plan), Material::Flagstones));
    cell.faces.push_back(planarFace(rectOnSide(Side::Ceiling, kApseHeight, plan), Material::OldPlanks));
    for (const auto& [side, at] : {std::pair{Side::South, kApseSouth}, std::pair{Side::North, kApseNorth}}) {
        cell.faces.push_back(planarFace(rectOnSide(side, at, {kApseWest, 0.0, kApseEast, kApseHeight}),
                                        Material::InnerPlaster));
    }
    for (const Rect& r : withoutHoles({kApseSouth, 0.0, kApseNorth, kApseHeight}, {kApseWindow}))
        cell.faces.push_back(planarFace(rectOnSide(Side::East, kApseEast, r), Material::InnerPlaster));
    const ArchWall west{Side::West, kApseWest,
                        0.0,        {{kApseSouth, kApseHeight}, {kApseNorth, kApseHeight}},
                        arch(),     Material::InnerPlaster};
    for (Face& face : wallFaces(west))
        cell.faces.push_back(std::move(face));
    cell.faces.push_back(holePortal(west));
    cell.faces.push_back(portalFace(rectOnSide(Side::East, kApseEast, kApseWindow)));
    closeSeams(cell.faces);
    cell.statics.push_back({addTrim(writer, {{{Side::East, kApseWindow}, kApseEast}}), {}});
    return cell;
}

dat::RecordId addColumn(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-0.30, -0.30, 0.0}, {0.30, 0.30, 0.18}, Material::Flagstones);
    mesh.cylinder({.base = {0, 0, 0.18},
                   .lower = 0.25,
                   .upper = 0.21,
                   .height = 3.32,
                   .sides = 14,
                   .side = Material::StoneWall,
                   .caps = false});
    mesh.box({-0.29, -0.29, 3.50}, {0.29, 0.29, 3.70}, Material::Flagstones);
    return writer.addSingle(mesh);
}

/// A tie beam across the nave with a king post and struts: middle at the origin, underside at z = 3.7.
dat::RecordId addTruss(ModelWriter& writer) {
    FaceMesh mesh;
    const double half = kMiddle - kWall - 0.01;
    mesh.beam({-0.12, -half, 3.7}, {0.12, half, 3.87}, Material::Beam);
    mesh.beam({-0.09, -0.10, 3.87}, {0.09, 0.10, 7.9}, Material::Beam);
    for (const double side : {-1.0, 1.0}) {
        mesh.strut({0.0, side * 0.08, 4.3}, {0.0, side * 1.75, 6.3}, {1, 0, 0}, 0.13, 0.13, Material::Beam);
        mesh.strut({0.0, side * (half - 0.2), 3.83}, {0.0, side * 0.08, 7.82}, {1, 0, 0}, 0.16, 0.18,
                   Material::Beam);
    }
    return writer.addSingle(mesh);
}

dat::RecordId addLectern(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-1.3, -1.8, 0.0}, {1.4, 1.8, 0.16}, Material::Flagstones);
    mesh.beam({-0.30, -0.30, 0.16}, {0.30, 0.30, 0.24}, Material::Oak);
    mesh.beam({-0.07, -0.07, 0.24}, {0.07, 0.07, 1.18}, Material::Oak);
    mesh.strut({-0.26, 0.0, 1.14}, {0.26, 0.0, 1.32}, {0, 1, 0}, 0.62, 0.05, Material::Oak);
    mesh.strut({-0.20, 0.0, 1.195}, {0.20, 0.0, 1.335}, {0, 1, 0}, 0.42, 0.05, Material::Linen);
    return writer.addSingle(mesh);
}

/// A carpet down the middle of the nave.
dat::RecordId addCarpet(ModelWriter& writer) {
    FaceMesh mesh;
    for (int k = 0; k < 4; ++k) {
        const double x = -4.4 + 2.2 * k;
        mesh.card({Vec3(x, 0.75, 0.008), Vec3(x, -0.75, 0.008), Vec3(x + 2.2, -0.75, 0.008),
                   Vec3(x + 2.2, 0.75, 0.008)},
                  Material::Rug, false);
    }
    return writer.addSingle(mesh);
}

void furnish(ModelWriter& writer, const Furniture& f, CellPlan& nave, CellPlan& apse) {
    const dat::RecordId column = addColumn(writer);
    const dat::RecordId truss = addTruss(writer);
    for (const double x : {-3.75 + 1.875, 1.875}) {
        nave.statics.push_back({truss, {{x, kMiddle, 0.0}, 0.0}});
        for (const double y : {kMiddle - 2.6, kMiddle + 2.6})
            nave.statics.push_back({column, {{x, y, 0.0}, 0.0}});
        nave.statics.push_back({f.lantern, {{x, kMiddle - 1.5, 3.7}, 0.0}});
        nave.statics.push_back({f.lantern, {{x, kMiddle + 1.5, 3.7}, 40.0}});
    }
    nave.statics.push_back({addCarpet(writer), {{0.6, kMiddle, 0.0}, 0.0}});
    for (const double x : {-2.9, -0.9, 0.9, 2.9})
        for (const double y : {kMiddle - 1.75, kMiddle + 1.75})
            nave.statics.push_back({f.bench, {{x, y, 0.0}, 90.0}});
    for (const double y : {kWall + 0.35, kWidth - kWall - 0.35}) {
        nave.statics.push_back({f.bench, {{-1.9, y, 0.0}, 0.0}});
        nave.statics.push_back({f.bench, {{1.9, y, 0.0}, 0.0}});
    }
    nave.statics.push_back({f.chest, {{5.6, 1.2, 0.0}, -90.0}});
    nave.statics.push_back({f.barrel, {{-5.6, 8.7, 0.0}, 0.0}});
    apse.statics.push_back({addLectern(writer), {{8.7, kMiddle, 0.0}, 0.0}});
    apse.statics.push_back({f.candle, {{9.2, kMiddle - 1.4, 0.16}, 0.0}});
    apse.statics.push_back({f.candle, {{9.2, kMiddle + 1.4, 0.16}, 0.0}});
    apse.statics.push_back({f.shelf, {{9.4, kApseNorth - 0.01, 0.0}, 0.0}});
    apse.statics.push_back({f.chest, {{9.4, kApseSouth + 0.35, 0.0}, 180.0}});
    apse.statics.push_back({f.lantern, {{7.6, kMiddle, kApseHeight}, 0.0}});
}

} // namespace

BuildingPlan planMeetingHall(ModelWriter& writer, const Furniture& furniture) {
    BuildingPlan plan;
    plan.name = "meeting hall";
    plan.exterior = buildHouseShell(naveShell());
    const HouseShell behind = apseShell();
    plan.exterior.append(buildHouseShell(behind),
                         {{6.25 + behind.halfWidth, kApseSouth - kWall, -kApseLower}, 0.0});
    plan.cells = {
        nave(writer),
        archedPassage("arch", kInnerEnd, kApseWest, 0.0, arch(), Material::StoneWall, Material::Flagstones),
        apse(writer)};
    furnish(writer, furniture, plan.cells[0], plan.cells[2]);
    return plan;
}

} // namespace limen::worlds
