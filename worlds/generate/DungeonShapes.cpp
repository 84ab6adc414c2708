#include "worlds/generate/DungeonShapes.h"

#include "core/Assert.h"
#include "worlds/generate/DungeonDoors.h"
#include "worlds/records/Carve.h"
#include "worlds/records/Seams.h"
#include "worlds/records/SolidTree.h"
#include "worlds/shapes/Panel.h"

namespace limen::worlds {

namespace {

Polygon onWall(const FlatOutline& outline, Way way, const RoomSize& size) {
    Polygon out;
    for (const Vec2& p : outline) {
        switch (way) {
        case Way::West:
            out.emplace_back(-size.halfX, p.x, p.y);
            break;
        case Way::East:
            out.emplace_back(size.halfX, p.x, p.y);
            break;
        case Way::South:
            out.emplace_back(-p.x, -size.halfY, p.y);
            break;
        case Way::North:
            out.emplace_back(-p.x, size.halfY, p.y);
            break;
        case Way::Down:
            out.emplace_back(p.x, p.y, 0.0);
            break;
        case Way::Up:
            out.emplace_back(p.x, p.y, size.height);
            break;
        }
    }
    return out;
}

/// The part of its box that a room lacks, seen from above; empty for a box.
std::vector<Rect> notchOf(Form form, const RoomSize& s) {
    constexpr double kCorner = 1.0, kSlot = 1.0;
    switch (form) {
    case Form::Box:
        return {};
    case Form::NoSouthWest:
        return {{-s.halfX, -s.halfY, -kCorner, -kCorner}};
    case Form::NoSouthEast:
        return {{kCorner, -s.halfY, s.halfX, -kCorner}};
    case Form::NoNorthWest:
        return {{-s.halfX, kCorner, -kCorner, s.halfY}};
    case Form::NoNorthEast:
        return {{kCorner, kCorner, s.halfX, s.halfY}};
    case Form::NoWest:
        return {{-s.halfX, -kSlot, 0.0, kSlot}};
    case Form::NoEast:
        return {{0.0, -kSlot, s.halfX, kSlot}};
    case Form::NoSouth:
        return {{-kSlot, -s.halfY, kSlot, 0.0}};
    case Form::NoNorth:
        return {{-kSlot, 0.0, kSlot, s.halfY}};
    }
    return {};
}

/// Adds the walls around a notch.
void addNotchWalls(std::vector<Face>& faces, const Rect& n, const RoomSize& s) {
    const auto add = [&](Side side, double at, double from, double to) {
        faces.push_back(planarFace(rectOnSide(side, at, {from, 0.0, to, s.height}), Material::StoneWall));
    };
    if (n.u0 > -s.halfX)
        add(Side::East, n.u0, n.v0, n.v1);
    if (n.u1 < s.halfX)
        add(Side::West, n.u1, n.v0, n.v1);
    if (n.v0 > -s.halfY)
        add(Side::North, n.v0, n.u0, n.u1);
    if (n.v1 < s.halfY)
        add(Side::South, n.v1, n.u0, n.u1);
}

struct RoomSide {
    Side side;
    Way way;
    double at;
    Rect rect;
    Material material;
};

std::array<RoomSide, 6> sidesOf(const RoomSize& s) {
    const Rect alongY{-s.halfY, 0.0, s.halfY, s.height};
    const Rect alongX{-s.halfX, 0.0, s.halfX, s.height};
    const Rect level{-s.halfX, -s.halfY, s.halfX, s.halfY};
    return {{{Side::West, Way::West, -s.halfX, alongY, Material::StoneWall},
             {Side::East, Way::East, s.halfX, alongY, Material::StoneWall},
             {Side::South, Way::South, -s.halfY, alongX, Material::StoneWall},
             {Side::North, Way::North, s.halfY, alongX, Material::StoneWall},
             {Side::Floor, Way::Down, 0.0, level, Material::Flagstones},
             {Side::Ceiling, Way::Up, s.height, level, Material::Brick}}};
}

/// The parts of notches in a side.
std::vector<Rect> holesIn(const RoomSide& side, const std::vector<Rect>& notches, const RoomSize& s) {
    std::vector<Rect> out;
    for (const Rect& n : notches) {
        const bool alongY = side.side == Side::West || side.side == Side::East;
        const bool touches = side.side == Side::West    ? n.u0 <= side.at
                             : side.side == Side::East  ? n.u1 >= side.at
                             : side.side == Side::South ? n.v0 <= side.at
                             : side.side == Side::North ? n.v1 >= side.at
                                                        : true;
        if (side.side == Side::Floor || side.side == Side::Ceiling)
            out.push_back(n);
        else if (touches)
            out.push_back(alongY ? Rect{n.v0, 0.0, n.v1, s.height} : Rect{n.u0, 0.0, n.u1, s.height});
    }
    return out;
}

std::vector<FlatOutline> outlinesOf(const LatticeRoom& room, Way way) {
    const Door door = room.doors[static_cast<std::size_t>(way)];
    if (door == Door::None || way < Way::Down)
        return openingOutlines(door);
    return {hatchOutline(door)};
}

void addWall(std::vector<Face>& faces, const Polygon& wall, std::span<const Polygon> holes,
             Material material) {
    for (Polygon& piece : withoutOpenings(wall, holes))
        faces.push_back(planarFace(std::move(piece), material));
}

} // namespace

std::vector<Face> roomShell(const LatticeRoom& room) {
    const RoomSize& size = kRoomSizes[room.size];
    const std::vector<Rect> notches = notchOf(room.form, size);
    std::vector<Face> faces, portals;
    for (const RoomSide& side : sidesOf(size)) {
        std::vector<Polygon> holes;
        for (const FlatOutline& outline : outlinesOf(room, side.way)) {
            holes.push_back(facing(onWall(outline, side.way, size), {0.0, 0.0, size.height / 2}));
            portals.push_back(portalFace(holes.back()));
        }
        for (const Rect& rect : withoutHoles(side.rect, holesIn(side, notches, size)))
            addWall(faces, rectOnSide(side.side, side.at, rect), holes, side.material);
    }
    for (const Rect& notch : notches)
        addNotchWalls(faces, notch, size);
    faces.insert(faces.end(), portals.begin(), portals.end());
    return faces;
}

Vec3 eyePoint(Form form) {
    switch (form) {
    case Form::NoWest:
        return {1.5, 0.3, 1.6};
    case Form::NoEast:
        return {-1.5, 0.3, 1.6};
    case Form::NoSouth:
        return {0.3, 1.5, 1.6};
    case Form::NoNorth:
        return {0.3, -1.5, 1.6};
    default:
        return {0.3, 0.2, 1.6};
    }
}

std::vector<Face> passageShell(Door door, double length, double rise, bool deadEnd) {
    const FlatOutline section = passageOutline(door);
    const auto at = [&](const Vec2& p, bool end) {
        return Vec3(end ? length : 0.0, p.x, p.y + (end ? rise : 0.0));
    };
    Vec3 inside(0.0);
    for (const Vec2& p : section)
        inside += (at(p, false) + at(p, true)) * (0.5 / static_cast<double>(section.size()));
    std::vector<Face> faces, portals;
    for (std::size_t i = 0; i < section.size(); ++i) {
        const Vec2& p = section[i];
        const Vec2& q = section[(i + 1) % section.size()];
        const Material material = i == 0                   ? Material::Flagstones
                                  : p.y > 2.0 && q.y > 2.0 ? Material::Brick
                                                           : Material::StoneWall;
        faces.push_back(
            planarFace(facing({at(p, false), at(q, false), at(q, true), at(p, true)}, inside), material));
    }
    for (const bool end : {false, true}) {
        const auto polygon = [&](const FlatOutline& outline) {
            Polygon out;
            for (const Vec2& p : outline)
                out.push_back(at(p, end));
            return facing(std::move(out), inside);
        };
        std::vector<Polygon> holes;
        for (const FlatOutline& outline :
             end&& deadEnd ? std::vector<FlatOutline>{} : openingOutlines(door)) {
            holes.push_back(polygon(outline));
            portals.push_back(portalFace(holes.back()));
        }
        addWall(faces, polygon(section), holes, Material::StoneWall);
    }
    faces.insert(faces.end(), portals.begin(), portals.end());
    return faces;
}

std::vector<Face> shaftShell(Door door, double length) {
    const FlatOutline section = hatchOutline(door);
    const Vec3 inside(0.0, 0.0, length / 2);
    std::vector<Face> faces;
    Polygon below, above;
    for (std::size_t i = 0; i < section.size(); ++i) {
        const Vec2& p = section[i];
        const Vec2& q = section[(i + 1) % section.size()];
        faces.push_back(planarFace(
            facing({{p.x, p.y, 0.0}, {q.x, q.y, 0.0}, {q.x, q.y, length}, {p.x, p.y, length}}, inside),
            Material::StoneWall));
        below.emplace_back(p.x, p.y, 0.0);
        above.emplace_back(p.x, p.y, length);
    }
    faces.push_back(portalFace(facing(below, inside)));
    faces.push_back(portalFace(facing(above, inside)));
    return faces;
}

Placement passagePlacement(const Passage& passage, const LatticeRoom& from) {
    const RoomSize& size = kRoomSizes[from.size];
    switch (passage.way) {
    case Way::East:
        return {from.floor + Vec3(size.halfX, 0.0, 0.0), 0.0};
    case Way::North:
        return {from.floor + Vec3(0.0, size.halfY, 0.0), 90.0};
    default:
        LIMEN_ASSERT(passage.way == Way::Up, "passages lead east, north or up");
        return {from.floor + Vec3(0.0, 0.0, size.height), 0.0};
    }
}

const StoredShape& DungeonShapes::of(const LatticeRoom& room) {
    std::array<long long, 10> key{0, room.size, static_cast<long long>(room.form)};
    for (std::size_t way = 0; way < kWays; ++way)
        key[3 + way] = static_cast<long long>(room.doors[way]);
    const auto found = shapes_.find(key);
    return found != shapes_.end() ? found->second : store(key, roomShell(room), eyePoint(room.form));
}

const StoredShape& DungeonShapes::of(const Passage& passage, double rise) {
    const auto eighths = [](double v) { return std::llround(v * 8.0); };
    const std::array<long long, 10> key{1,
                                        passage.way == Way::Up ? 1 : 0,
                                        static_cast<long long>(passage.door),
                                        eighths(passage.length),
                                        eighths(rise),
                                        passage.to == kNothing ? 1 : 0};
    const auto found = shapes_.find(key);
    if (found != shapes_.end())
        return found->second;
    const Vec3 middle = passage.way == Way::Up ? Vec3(0.0, 0.0, passage.length / 2)
                                               : Vec3(passage.length / 2, 0.0, rise / 2 + 1.0);
    return store(key,
                 passage.way == Way::Up
                     ? shaftShell(passage.door, passage.length)
                     : passageShell(passage.door, passage.length, rise, passage.to == kNothing),
                 middle);
}

const StoredShape& DungeonShapes::store(const std::array<long long, 10>& key, std::vector<Face> faces,
                                        const Vec3& middle) {
    closeSeams(faces, finestGrid(faces));
    dat::BspTree tree = buildSolidCellBsp(faces, middle);
    return shapes_[key] = library_.add(std::move(faces), std::move(tree));
}

} // namespace limen::worlds
