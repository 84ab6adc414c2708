#include "worlds/builtin/dungeon/DungeonHub.h"

namespace limen::worlds {

namespace {

constexpr double kRingSide = 24.0; ///< metres from the hub's middle to the ring's corridors
constexpr double kHubReach = 8.0, kHubHalf = 3.0, kHubHeight = 8.0;
constexpr double kRingRoomHalf = 2.0, kRingRoomHeight = 5.0;
constexpr double kSpan = 4.0; ///< length of a corridor's cell

Vec3 hubMiddle() {
    return {0.0, kHubY, kDungeonFloor};
}

/// The direction from the hub to a room; components are -1, 0 or 1.
Vec3 wayTo(std::size_t room) {
    constexpr std::array<std::array<double, 2>, 8> kWays{
        {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};
    return {kWays[room][0], kWays[room][1], 0.0};
}

bool isDiagonal(const Vec3& way) {
    return way.x != 0.0 && way.y != 0.0;
}

/// The horizontal direction perpendicular to `way`.
Vec3 acrossOf(const Vec3& way) {
    return isDiagonal(way) ? Vec3(1.0, -way.x * way.y, 0.0) : Vec3(std::abs(way.y), std::abs(way.x), 0.0);
}

std::size_t addOctagon(CellComplex& complex, const std::string& name, const Vec3& middle, double reach,
                       double half, double height, const ShellMaterials& materials) {
    Outline floor = levelOutline(octagon(reach, half), 0.0);
    for (Vec3& p : floor)
        p += middle;
    return complex.addSwept(name, floor, {0.0, 0.0, height}, materials);
}

/// Adds a straight corridor between two bodies, from the middle of its first sill. Returns its first cell.
std::size_t connect(CellComplex& complex, const std::string& name, std::size_t from, std::size_t to,
                    const Vec3& foot, const Vec3& step, std::size_t count, double half,
                    const ShellMaterials& materials) {
    const Vec3 across = acrossOf(glm::sign(step));
    const Outline start = corridorOutline(foot, across, half);
    const std::size_t first = complex.addRun(name, start, step, count, materials);
    complex.join(from, first, start);
    Outline end = start;
    for (Vec3& p : end)
        p += step * static_cast<double>(count);
    complex.join(first + count - 1, to, end);
    return first;
}

/// Adds the anteroom to the north. Two doors of the hub lead into it.
std::size_t addAnteroom(CellComplex& complex, std::size_t hub, std::size_t northRoom) {
    const double y = kHubY + kHubReach;
    const std::size_t anteroom =
        addBoxCell(complex, "anteroom", {-3.0, y, kDungeonFloor}, {3.0, y + 4.0, -12.0}, kMasonry);
    for (const double x : {-1.5, 1.5})
        complex.join(hub, anteroom, corridorOutline({x, y, kDungeonFloor}, {1, 0, 0}, 0.875));
    connect(complex, "spoke.north", anteroom, northRoom, {0.0, y + 4.0, kDungeonFloor}, {0.0, kSpan, 0.0}, 2,
            1.25, kMasonry);
    return anteroom;
}

void addSpokes(CellComplex& complex, const Ring& ring) {
    for (std::size_t k = 0; k < ring.rooms.size(); ++k) {
        const Vec3 way = wayTo(k);
        const std::string name = "spoke." + std::to_string(k);
        if (isDiagonal(way)) {
            const double from = 0.5 * (kHubReach + kHubHalf);
            const double to = kRingSide - 0.5 * (kRingRoomReach + kRingRoomHalf);
            connect(complex, name, ring.hub, ring.rooms[k], hubMiddle() + way * from,
                    way * ((to - from) / 4.0), 4, 0.75, kBricks);
        } else if (k != static_cast<std::size_t>(RingRoom::North)) {
            connect(complex, name, ring.hub, ring.rooms[k], hubMiddle() + way * kHubReach,
                    way * ((kRingSide - kRingRoomReach - kHubReach) / 2.0), 2, 1.25, kMasonry);
        }
    }
}

void addRingCorridors(CellComplex& complex, const DungeonProps& props, const Ring& ring) {
    for (std::size_t k = 0; k < ring.rooms.size(); ++k) {
        const std::size_t next = (k + 1) % ring.rooms.size();
        const Vec3 way = wayTo(next) - wayTo(k);
        const Vec3 foot = hubMiddle() + wayTo(k) * kRingSide + way * kRingRoomReach;
        const std::size_t first = connect(complex, "ring." + std::to_string(k), ring.rooms[k],
                                          ring.rooms[next], foot, way * kSpan, 4, 1.25, kBricks);
        const Vec3 out{way.y, -way.x, 0.0}; // the ring is counter-clockwise, so outwards is to the right
        hangTorch(complex, first + 1, props, foot + way * (1.5 * kSpan) + out * 1.25 + Vec3(0, 0, 1.05), out);
    }
}

void furnishHub(CellComplex& complex, ModelWriter& writer, const DungeonProps& props, std::size_t hub) {
    const dat::RecordId column = addColumn(writer, kHubHeight, 0.5);
    for (const Vec2& p : octagon(5.25, 2.175))
        complex.furnish(hub, {column, {hubMiddle() + Vec3(p, 0.0), 0.0}});
    complex.furnish(hub, {props.brazier, {hubMiddle(), 0.0}});
    for (const double side : {-1.0, 1.0}) {
        hangTorch(complex, hub, props, hubMiddle() + Vec3(side * kHubReach, 2.1, 2.2), {side, 0.0, 0.0});
        hangTorch(complex, hub, props, hubMiddle() + Vec3(side * 2.1, -kHubReach, 2.2), {0.0, -1.0, 0.0});
    }
    hangTorch(complex, hub, props, hubMiddle() + Vec3(0.0, kHubReach, 2.2), {0.0, 1.0, 0.0});
}

void furnishRing(CellComplex& complex, const DungeonProps& props, const Ring& ring) {
    for (std::size_t k = 0; k < ring.rooms.size(); ++k) {
        const Vec3 middle = hubMiddle() + wayTo(k) * kRingSide;
        const double turn = 37.0 * static_cast<double>(k);
        if (isDiagonal(wayTo(k))) {
            complex.furnish(ring.rooms[k], {props.brazier, {middle, turn}});
            complex.furnish(ring.rooms[k],
                            {props.house.crate, {middle + wayTo(k) * Vec3(2.7, 2.0, 0.0), turn}});
            complex.furnish(ring.rooms[k],
                            {props.house.barrel, {middle + wayTo(k) * Vec3(1.8, 2.9, 0.0), turn}});
        } else {
            const Vec3 out = wayTo(k);
            const Vec3 side = acrossOf(out) * 1.65;
            hangTorch(complex, ring.rooms[k], props, middle - out * kRingRoomReach + side + Vec3(0, 0, 1.9),
                      -out);
        }
    }
}

} // namespace

void hangTorch(CellComplex& complex, std::size_t cell, const DungeonProps& props, const Vec3& at,
               const Vec3& wall) {
    const double turn = wall.y > 0.5 ? 0.0 : wall.y < -0.5 ? 180.0 : wall.x > 0.5 ? -90.0 : 90.0;
    complex.furnish(cell, {props.torch, {at - wall * 0.004, turn}});
}

std::size_t addBoxCell(CellComplex& complex, const char* name, const Vec3& min, const Vec3& max,
                       const ShellMaterials& materials) {
    return complex.addSwept(name, levelOutline(rectangle(min.x, min.y, max.x, max.y), min.z),
                            {0.0, 0.0, max.z - min.z}, materials);
}

Vec3 ringRoomMiddle(RingRoom room) {
    return hubMiddle() + wayTo(static_cast<std::size_t>(room)) * kRingSide;
}

Ring addHub(CellComplex& complex, ModelWriter& writer, const DungeonProps& props) {
    Ring ring;
    ring.hub = addOctagon(complex, "hub", hubMiddle(), kHubReach, kHubHalf, kHubHeight, kMasonry);
    for (std::size_t k = 0; k < ring.rooms.size(); ++k) {
        ring.rooms[k] =
            addOctagon(complex, "ring.room." + std::to_string(k), hubMiddle() + wayTo(k) * kRingSide,
                       kRingRoomReach, kRingRoomHalf, kRingRoomHeight, kMasonry);
    }
    ring.anteroom = addAnteroom(complex, ring.hub, ring.at(RingRoom::North));
    addSpokes(complex, ring);
    addRingCorridors(complex, props, ring);
    furnishHub(complex, writer, props, ring.hub);
    furnishRing(complex, props, ring);
    return ring;
}

} // namespace limen::worlds
