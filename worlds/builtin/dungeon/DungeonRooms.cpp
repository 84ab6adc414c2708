#include "worlds/builtin/dungeon/DungeonHub.h"

namespace limen::worlds {

namespace {

Outline shifted(Outline outline, const Vec3& by) {
    for (Vec3& p : outline)
        p += by;
    return outline;
}

} // namespace

void addCrypt(CellComplex& complex, ModelWriter& writer, const DungeonProps& props, const Ring& ring,
              DungeonParts& parts) {
    const Vec3 foot = ringRoomMiddle(RingRoom::North) + Vec3(0.0, kRingRoomReach, 0.0);
    const double y = foot.y + 4.0; // y of the crypt's southern wall
    const double z = kDungeonFloor;
    const Outline door = corridorOutline(foot, {1, 0, 0});
    const std::size_t way = complex.addSwept("crypt.way", door, {0.0, 4.0, 0.0}, kMasonry);
    complex.join(ring.at(RingRoom::North), way, door);
    parts.crypt = addBoxCell(complex, "crypt", {-8.0, y, z}, {8.0, y + 12.0, z + 6.0}, kMasonry);
    complex.join(way, parts.crypt, shifted(door, {0.0, 4.0, 0.0}));
    // The corridor: one step up, out through the eastern door, round behind, through the crypt's own volume,
    // in through the western door.
    const double step = z + 0.25;
    const double top = step + 3.0;
    const ShellMaterials& brick = kBricks;
    parts.wrap = addBoxCell(complex, "wrap", {8.0, y + 1.0, step}, {12.0, y + 5.0, top}, brick);
    parts.wrapCount = 6;
    addBoxCell(complex, "wrap", {9.0, y + 5.0, step}, {12.0, y + 11.0, top}, brick);
    addBoxCell(complex, "wrap", {0.0, y + 8.0, step}, {9.0, y + 11.0, top}, brick);
    addBoxCell(complex, "wrap", {-9.0, y + 8.0, step}, {0.0, y + 11.0, top}, brick);
    addBoxCell(complex, "wrap", {-12.0, y + 5.0, step}, {-9.0, y + 11.0, top}, brick);
    addBoxCell(complex, "wrap", {-12.0, y + 1.0, step}, {-8.0, y + 5.0, top}, brick);
    complex.join(parts.crypt, parts.wrap, corridorOutline({8.0, y + 3.0, step}, {0, 1, 0}));
    complex.join(parts.wrap, parts.wrap + 1, rectOutline({{10.5, y + 5.0, step}, {1, 0, 0}, 1.5}, 3.0));
    for (std::size_t k = 1; k < 4; ++k) {
        const double x = 9.0 * (2.0 - static_cast<double>(k));
        complex.join(parts.wrap + k, parts.wrap + k + 1,
                     rectOutline({{x, y + 9.5, step}, {0, 1, 0}, 1.5}, 3.0));
    }
    complex.join(parts.wrap + 4, parts.wrap + 5, rectOutline({{-10.5, y + 5.0, step}, {1, 0, 0}, 1.5}, 3.0));
    complex.join(parts.wrap + 5, parts.crypt, corridorOutline({-8.0, y + 3.0, step}, {0, 1, 0}));
    const dat::RecordId column = addColumn(writer, 6.0, 0.4);
    for (const double x : {-5.0, 5.0})
        for (const double along : {2.5, 9.5})
            complex.furnish(parts.crypt, {column, {{x, y + along, z}, 0.0}});
    FaceMesh tomb;
    tomb.box({-1.3, -0.7, 0.0}, {1.3, 0.7, 0.31}, Material::Flagstones);
    tomb.box({-1.1, -0.5, 0.31}, {1.1, 0.5, 0.85}, Material::StoneWall);
    tomb.box({-1.2, -0.6, 0.85}, {1.2, 0.6, 1.0}, Material::Flagstones);
    const dat::RecordId tombs = writer.addSetup({{writer.addMesh(tomb), {}}});
    for (const double x : {-3.0, 0.0, 3.0})
        complex.furnish(parts.crypt, {tombs, {{x, y + 7.0, z}, 90.0}});
    for (const double x : {-3.0, 3.0})
        hangTorch(complex, parts.crypt, props, {x, y + 12.0, z + 2.1}, {0.0, 1.0, 0.0});
    for (const double side : {-1.0, 1.0}) {
        hangTorch(complex, parts.crypt, props, {side * 8.0, y + 6.5, z + 2.1}, {side, 0.0, 0.0});
        hangTorch(complex, parts.crypt, props, {side * 2.5, y, z + 2.1}, {0.0, -1.0, 0.0});
    }
    hangTorch(complex, parts.wrap + 2, props, {4.5, y + 11.0, step + 1.7}, {0.0, 1.0, 0.0});
    hangTorch(complex, parts.wrap + 1, props, {12.0, y + 8.0, step + 1.7}, {1.0, 0.0, 0.0});
    hangTorch(complex, parts.wrap + 4, props, {-12.0, y + 8.0, step + 1.7}, {-1.0, 0.0, 0.0});
}

void addRecess(CellComplex& complex, const DungeonProps& props, const Ring& ring, DungeonParts& parts) {
    const Vec3 foot = ringRoomMiddle(RingRoom::SouthEast) - Vec3(0.0, kRingRoomReach, 0.0);
    const double z = kDungeonFloor;
    const double high = 4.0;
    const double y = foot.y - 4.0; // y of the room's northern wall
    const Outline door = corridorOutline(foot, {1, 0, 0});
    const std::size_t way = complex.addSwept("recess.way", door, {0.0, -4.0, 0.0}, kMasonry);
    complex.join(ring.at(RingRoom::SouthEast), way, door);
    // The U's outline, counter-clockwise seen from above; the yard is between its arms.
    const double west = foot.x - 8.0, east = foot.x + 8.0, left = foot.x - 3.0, right = foot.x + 3.0;
    const double south = y - 12.0, notch = y - 5.0;
    const std::vector<Vec2> around{{west, south},  {left, south}, {left, notch}, {right, notch},
                                   {right, south}, {east, south}, {east, y},     {west, y}};
    std::vector<Face> faces;
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Vec3 a(around[i], z);
        const Vec3 b(around[(i + 1) % around.size()], z);
        const Vec3 up{0.0, 0.0, high};
        faces.push_back(planarFace({b, a, a + up, b + up}, Material::StoneWall));
    }
    for (const auto& part : {rectangle(west, south, left, notch), rectangle(right, south, east, notch),
                             rectangle(west, notch, east, y)}) {
        faces.push_back(planarFace(levelOutline(part, z), Material::Flagstones));
        faces.push_back(flipped(planarFace(levelOutline(part, z + high), Material::StoneWall)));
    }
    // The yard comes first. The U's tree contains it too, and a search for a point's cell takes the first
    // that matches.
    parts.yard = addBoxCell(complex, "yard", {left, south, z}, {right, notch, z + 9.0}, kBareRock);
    parts.recess = complex.add("recess", std::move(faces));
    complex.join(way, parts.recess, shifted(door, {0.0, -4.0, 0.0}));
    for (const double x : {left, right}) {
        complex.join(parts.recess, parts.yard,
                     archOutline({{x, south + 3.5, z + 0.75}, {0, 1, 0}, 1.5}, 1.25, 2.25));
    }
    complex.furnish(parts.yard, {props.brazier, {{foot.x, south + 5.3, z}, 20.0}});
    hangTorch(complex, parts.recess, props, {west, south + 3.5, z + 1.9}, {-1.0, 0.0, 0.0});
    hangTorch(complex, parts.recess, props, {east, south + 3.5, z + 1.9}, {1.0, 0.0, 0.0});
    hangTorch(complex, parts.recess, props, {foot.x + 3.0, y, z + 1.9}, {0.0, 1.0, 0.0});
    complex.furnish(parts.recess, {props.house.crate, {{west + 1.0, y - 1.0, z}, 12.0}});
    complex.furnish(parts.recess, {props.house.chest, {{east - 1.2, y - 0.6, z}, 0.0}});
    complex.furnish(parts.recess, {props.house.barrel, {{east - 0.6, south + 0.7, z}, 0.0}});
}

void addLongCorridor(CellComplex& complex, ModelWriter& writer, const DungeonProps& props, const Ring& ring,
                     DungeonParts& parts) {
    constexpr std::size_t kCells = 12;
    const Vec3 step{6.0, 0.0, 0.0};
    const Vec3 foot = ringRoomMiddle(RingRoom::East) + Vec3(kRingRoomReach, 0.0, 0.0);
    const Outline door = corridorOutline(foot, {0, 1, 0}, 1.5);
    parts.longCorridor = complex.addRun("long", door, step, kCells, kMasonry);
    parts.longCorridorCount = kCells;
    complex.join(ring.at(RingRoom::East), parts.longCorridor, door);
    for (std::size_t k = 1; k < kCells; k += 2) {
        const double side = k % 4 == 1 ? 1.0 : -1.0;
        hangTorch(complex, parts.longCorridor + k, props,
                  foot + step * (static_cast<double>(k) + 0.5) + Vec3(0.0, 1.5 * side, 1.05),
                  {0.0, side, 0.0});
    }
    const Vec3 end = foot + step * static_cast<double>(kCells);
    const std::size_t shrine =
        addBoxCell(complex, "shrine", end - Vec3(0.0, 4.0, 0.0), end + Vec3(6.0, 4.0, 5.0), kMasonry);
    complex.join(parts.longCorridor + kCells - 1, shrine, corridorOutline(end, {0, 1, 0}, 1.5));
    complex.furnish(shrine, {props.brazier, {end + Vec3(4.5, 0.0, 0.0), 0.0}});
    const dat::RecordId column = addColumn(writer, 5.0, 0.35);
    for (const double y : {-2.8, 2.8})
        complex.furnish(shrine, {column, {end + Vec3(3.0, y, 0.0), 0.0}});
}

Outline tunnelOutline(double x, double y, double z) {
    // The vertical line through each corner meets the other sides at points of the grid, so walls can be cut
    // exactly.
    const std::vector<Vec2> around{{-1.25, 0.0}, {1.25, 0.0},   {1.75, 1.0},   {1.625, 2.0},  {1.25, 2.75},
                                   {0.5, 3.125}, {-0.5, 3.125}, {-1.25, 2.75}, {-1.625, 2.0}, {-1.75, 1.0}};
    Outline out;
    for (const Vec2& p : around)
        out.emplace_back(x + p.x, y, z + p.y);
    return out;
}

DungeonParts addDungeonCells(CellComplex& complex, ModelWriter& writer, const DungeonProps& props,
                             std::size_t entrance) {
    DungeonParts parts;
    const Ring ring = addHub(complex, writer, props);
    parts.hub = ring.hub;
    parts.anteroom = ring.anteroom;
    complex.join(entrance, ring.at(RingRoom::South), tunnelOutline(0.0, kEntranceY, kDungeonFloor));
    addPit(complex, props, ring, parts);
    addCrypt(complex, writer, props, ring, parts);
    addRecess(complex, props, ring, parts);
    addLongCorridor(complex, writer, props, ring, parts);
    return parts;
}

std::vector<CellPlan> planSealedDungeon(ModelWriter& writer, const DungeonProps& props) {
    CellComplex complex;
    const std::size_t hall =
        complex.addSwept("hall", levelOutline(octagon(6.0, 2.5), 0.0), {0.0, 0.0, 6.0}, kMasonry);
    complex.furnish(hall, {props.brazier, {}});
    const dat::RecordId column = addColumn(writer, 6.0, 0.4);
    for (const Vec2& p : octagon(4.25, 1.75))
        complex.furnish(hall, {column, {Vec3(p, 0.0), 0.0}});
    // A way out to the east, round to the north, and back in.
    const auto box = [&](const char* name, const Vec3& min, const Vec3& max) {
        return addBoxCell(complex, name, min, max, kBricks);
    };
    const std::size_t east = box("east", {6.0, -3.0, 0.0}, {12.0, 3.0, 4.0});
    const std::size_t lane = box("lane", {8.0, 3.0, 0.0}, {10.0, 8.0, 3.0});
    const std::size_t corner = box("corner", {6.0, 8.0, 0.0}, {12.0, 12.0, 4.0});
    const std::size_t back = box("back", {3.0, 8.5, 0.0}, {6.0, 11.5, 3.0});
    const std::size_t north = box("north", {-3.0, 6.0, 0.0}, {3.0, 12.0, 4.0});
    complex.join(hall, east, corridorOutline({6.0, 0.0, 0.0}, {0, 1, 0}));
    complex.join(east, lane, rectOutline({{9.0, 3.0, 0.0}, {1, 0, 0}, 1.0}, 3.0));
    complex.join(lane, corner, rectOutline({{9.0, 8.0, 0.0}, {1, 0, 0}, 1.0}, 3.0));
    complex.join(corner, back, rectOutline({{6.0, 10.0, 0.0}, {0, 1, 0}, 1.5}, 3.0));
    complex.join(back, north, rectOutline({{3.0, 10.0, 0.0}, {0, 1, 0}, 1.5}, 3.0));
    complex.join(north, hall, corridorOutline({0.0, 6.0, 0.0}, {1, 0, 0}));
    hangTorch(complex, hall, props, {-6.0, 0.0, 1.9}, {-1.0, 0.0, 0.0});
    hangTorch(complex, hall, props, {0.0, -6.0, 1.9}, {0.0, -1.0, 0.0});
    hangTorch(complex, east, props, {12.0, 0.0, 1.9}, {1.0, 0.0, 0.0});
    hangTorch(complex, corner, props, {12.0, 10.0, 1.9}, {1.0, 0.0, 0.0});
    hangTorch(complex, north, props, {-3.0, 9.0, 1.9}, {-1.0, 0.0, 0.0});
    complex.furnish(north, {props.house.chest, {{0.0, 11.6, 0.0}, 0.0}});
    complex.furnish(east, {props.house.crate, {{11.2, 2.2, 0.0}, 20.0}});
    return complex.finish();
}

} // namespace limen::worlds
