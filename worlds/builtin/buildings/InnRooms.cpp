#include "worlds/builtin/buildings/InnRooms.h"

#include "core/Assert.h"
#include "worlds/builtin/buildings/InnKit.h"
#include "worlds/builtin/buildings/RoomParts.h"

namespace limen::worlds {

namespace inn {

namespace {

/// The doors and windows in outer walls of this room.
std::vector<Opening> outerOpenings(const RoomSpec& room) {
    std::vector<Opening> out;
    const auto collect = [&](const std::vector<Opening>& all) {
        for (const Opening& o : all) {
            const bool alongY = o.side == Side::West || o.side == Side::East;
            const double outer = o.side == Side::West    ? -7.7
                                 : o.side == Side::East  ? 7.7
                                 : o.side == Side::South ? 0.3
                                                         : 10.7;
            const double from = alongY ? room.min.y : room.min.x;
            const double to = alongY ? room.max.y : room.max.x;
            if (planeOfSide(room.min, room.max, o.side) == outer && o.rect.u0 > from && o.rect.u1 < to &&
                o.rect.v0 >= room.min.z && o.rect.v1 <= room.max.z)
                out.push_back(o);
        }
    };
    collect(innDoors());
    collect(innWindows());
    return out;
}

/// The cell inside the wall between two rooms.
CellPlan throughWall(const char* name, Axis axis, double from, double to, const Rect& r,
                     Material walls = Material::Beam, Material floor = Material::Oak) {
    return axis == Axis::X ? doorway(name, {from, r.u0, r.v0}, {to, r.u1, r.v1}, axis, walls, floor)
                           : doorway(name, {r.u0, from, r.v0}, {r.u1, to, r.v1}, axis, walls, floor);
}

CellPlan cellarPassage(const char* name, double from, double to, const Rect& r) {
    return throughWall(name, Axis::X, from, to, r, Material::StoneWall, Material::Flagstones);
}

} // namespace

CellPlan furnished(ModelWriter& writer, const RoomSpec& room, std::vector<Opening> openings,
                   std::vector<Furnishing> statics) {
    for (const Opening& o : outerOpenings(room))
        openings.push_back(o);
    CellPlan cell = roomWithOpenings(room, openings);
    std::vector<WallOpening> framed;
    for (const Opening& o : openings)
        if (o.side != Side::Floor && o.side != Side::Ceiling)
            framed.push_back({o, planeOfSide(room.min, room.max, o.side)});
    cell.statics = std::move(statics);
    cell.statics.push_back({addTrim(writer, framed, room.min.z), {}});
    return cell;
}

} // namespace inn

std::vector<CellPlan> planInnRooms(ModelWriter& writer, const Furniture& furniture) {
    using namespace inn;
    Kit kit{writer, furniture, addInnProps(writer)};
    std::vector<CellPlan> cells;
    cells.push_back(innHall(kit));
    cells.push_back(throughWall("kitchen door", Axis::Y, 6.4, 6.6, kKitchenDoor));
    cells.push_back(kitchen(kit));
    cells.push_back(throughWall("back door", Axis::X, 1.4, 1.6, kBackDoor));
    cells.push_back(passage(kit));
    cells.push_back(throughWall("passage door", Axis::Y, 5.0, 5.2, kPassageDoor));
    cells.push_back(parlour(kit));
    cells.push_back(throughWall("parlour door", Axis::X, 1.4, 1.6, kParlourDoor));
    cells.push_back(throughWall("stairs door", Axis::X, 3.0, 3.2, kStairsDoor));
    cells.push_back(stairs(kit));
    cells.push_back(throughWall("landing door", Axis::X, 3.0, 3.2, kLandingDoor));
    cells.push_back(landing(kit));
    cells.push_back(doorway("shaft", {kShaft.u0, kShaft.v0, kHeight}, {kShaft.u1, kShaft.v1, kUpper}, Axis::Z,
                            Material::Beam, Material::Beam));
    cells.push_back(throughWall("west room door", Axis::X, -2.8, -2.6, kWestRoomDoor));
    cells.push_back(westRoom(kit));
    cells.push_back(throughWall("north room door", Axis::X, -2.8, -2.6, kNorthRoomDoor));
    cells.push_back(northRoom(kit));
    cells.push_back(throughWall("east room door", Axis::X, 3.0, 3.2, kEastRoomDoor));
    cells.push_back(eastRoom(kit));
    cells.push_back(throughWall("store door", Axis::Y, 5.0, 5.2, kStoreDoor));
    cells.push_back(store(kit));
    cells.push_back(basementStairs(kit));
    cells.push_back(cellarPassage("basement door", 4.6, 4.8, kBasementDoor));
    cells.push_back(basement(kit));
    cells.push_back(cellarPassage("vault arch", -1.7, -1.5, kVaultArch));
    cells.push_back(vault(kit));
    LIMEN_ASSERT(cells.size() == static_cast<std::size_t>(InnCell::Count), "a cell of the inn is missing");
    return cells;
}

} // namespace limen::worlds
