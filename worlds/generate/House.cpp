#include "worlds/generate/House.h"

#include "core/Assert.h"
#include "worlds/builtin/buildings/HouseShell.h"
#include "worlds/generate/Furnish.h"
#include "worlds/records/Carve.h"
#include "worlds/shapes/RoomPlan.h"

namespace limen::worlds {

namespace {

constexpr double kWall = 0.25, kAtticHeight = 2.25, kCellarDepth = 2.25, kHatch = 1.25; ///< metres
constexpr double kFloorUp = 0.3; ///< metres: height of the floor, for the steps before doors

/// An opening of a planned room, and the room behind it.
struct Way {
    Opening opening;
    std::uint32_t to = CellLink::kOutside;
    bool door = false;
};

struct Room {
    RoomSpec spec;
    std::vector<Way> ways;
    RoomUse use = RoomUse::Living;
};

class HousePlanner {
public:
    HousePlanner(const HouseSpec& spec, const Props& props, Random& random)
        : s_(spec), props_(props), random_(random), inner_{-spec.halfWidth + kWall, kWall,
                                                           spec.halfWidth - kWall, spec.depth - kWall} {}

    House plan() {
        addGroundFloor();
        if (s_.cellar)
            addBelow();
        if (s_.attic)
            addAttic();
        for (std::uint32_t r = 0; r < rooms_.size(); ++r)
            addCell(r);
        link();
        if (props_.furnished) {
            out_.plan.exterior = buildHouseShell(houseShell());
        } else {
            addWalls();
            addRoof();
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] Room room(const Rect& rect, double from, double to, Material walls) const {
        Room room;
        room.spec = {.name = {},
                     .min = {rect.u0, rect.v0, from},
                     .max = {rect.u1, rect.v1, to},
                     .floor = Material::Planks,
                     .walls = walls,
                     .ceiling = Material::Beam};
        return room;
    }

    void window(Room& room, Side side, double middle, double sill) {
        room.ways.push_back(
            {{side, {middle - kWindowWidth / 2, sill, middle + kWindowWidth / 2, sill + kWindowHeight}}});
    }

    void addGroundFloor() {
        const double doorX = random_.chance(0.5) ? -0.75 : 0.75;
        const Rect door{doorX - kDoorWidth / 2, 0.0, doorX + kDoorWidth / 2, kDoorHeight};
        const double middle =
            s_.divided ? std::floor((0.4 + 0.2 * random_.unit()) * s_.depth * 8.0) / 8.0 : inner_.v1;
        rooms_.push_back(
            room({inner_.u0, inner_.v0, inner_.u1, middle}, 0.0, s_.height, Material::InnerPlaster));
        rooms_[0].ways.push_back({{Side::South, door}, CellLink::kOutside, true});
        if (random_.chance(0.7))
            window(rooms_[0], Side::South, -2.2 * doorX, 0.875);
        if (s_.divided) {
            rooms_[0].ways.push_back({{Side::North, door}, 1, true});
            rooms_.push_back(
                room({inner_.u0, middle, inner_.u1, inner_.v1}, 0.0, s_.height, Material::StoneWall));
            rooms_[1].ways.push_back({{Side::South, door}, 0, true});
            rooms_[1].use = RoomUse::Sleeping;
        }
        Room& back = rooms_.back();
        window(back, Side::North, doorX, 0.875);
        for (const Side side : {Side::West, Side::East})
            if (random_.chance(0.5))
                window(back, side, 0.5 * (back.spec.min.y + back.spec.max.y), 0.875);
    }

    /// The hatch in a corner of the rearmost room.
    [[nodiscard]] Rect hatchOf(const Room& room, bool east) const {
        const double u = east ? room.spec.max.x - 0.25 - kHatch : room.spec.min.x + 0.25;
        const double v = room.spec.max.y - 0.5 - kHatch;
        return {u, v, u + kHatch, v + kHatch};
    }

    void addBelow() {
        const auto above = static_cast<std::uint32_t>(rooms_.size()) - 1;
        const auto below = static_cast<std::uint32_t>(rooms_.size());
        const Rect hatch = hatchOf(rooms_[above], true);
        const RoomSpec& over = rooms_[above].spec;
        rooms_[above].ways.push_back({{Side::Floor, hatch}, below, false});
        rooms_.push_back(
            room({over.min.x, over.min.y, over.max.x, over.max.y}, -kCellarDepth, 0.0, Material::Rock));
        rooms_[below].ways.push_back({{Side::Ceiling, hatch}, above, false});
        rooms_[below].use = RoomUse::Storing;
    }

    void addAttic() {
        const std::uint32_t below = s_.divided ? 1 : 0;
        const auto above = static_cast<std::uint32_t>(rooms_.size());
        const Rect hatch = hatchOf(rooms_[below], false);
        rooms_[below].ways.push_back({{Side::Ceiling, hatch}, above, false});
        rooms_.push_back(room(inner_, s_.height, s_.height + kAtticHeight, Material::Plaster));
        rooms_[above].ways.push_back({{Side::Floor, hatch}, below, false});
        rooms_[above].use = RoomUse::Sleeping;
        window(rooms_[above], Side::South, 0.25, s_.height + 0.75);
        if (random_.chance(0.6))
            window(rooms_[above], Side::East, 0.5 * s_.depth, s_.height + 0.75);
    }

    void addCell(std::uint32_t index) {
        const Room& room = rooms_[index];
        std::vector<Opening> openings;
        CellPlan cell;
        for (const Way& way : room.ways) {
            const auto portal = static_cast<std::uint16_t>(openings.size());
            openings.push_back(way.opening);
            cell.links.push_back({way.to, dat::kNoPortal});
            const Side side = way.opening.side;
            const bool alongY = side == Side::West || side == Side::East;
            const Rect& r = way.opening.rect;
            if (side != Side::Floor && side != Side::Ceiling) {
                const double at = planeOfSide(room.spec.min, room.spec.max, side);
                // A door between rooms is listed once.
                if (way.to == CellLink::kOutside || way.to > index) {
                    out_.openings.push_back({index, portal,
                                             alongY ? Vec3(at, r.u0, r.v0) : Vec3(r.u0, at, r.v0), alongY,
                                             way.door});
                }
            }
            if (way.to == CellLink::kOutside) {
                out_.plan.exits.push_back({index, portal});
                holes_.push_back(way.opening);
            }
        }
        cell.faces = roomWithOpenings(room.spec, openings).faces;
        const Vec3 middle = (room.spec.min + room.spec.max) * 0.5;
        cell.eye = {middle.x, middle.y, room.spec.min.z + 1.6};
        furnish(cell, room);
        if (props_.furnished)
            furnishRoom(cell.statics, room.spec, openings, room.use, props_, apartFrom(random_));
        out_.plan.cells.push_back(std::move(cell));
    }

    void furnish(CellPlan& cell, const Room& room) {
        const Vec3 corner(room.spec.min.x + 0.6, room.spec.min.y + 0.6, room.spec.min.z);
        if (random_.chance(0.7))
            cell.statics.push_back({pickProp(props_, random_), {corner, random_.between(0.0, 90.0)}});
        if (random_.chance(0.3)) {
            // On the sill, half in and half out.
            const auto way = std::find_if(room.ways.begin(), room.ways.end(), [](const Way& w) {
                return w.opening.side == Side::North && w.to == CellLink::kOutside;
            });
            if (way != room.ways.end()) {
                const Rect& r = way->opening.rect;
                cell.statics.push_back(
                    {props_.rod, {{0.5 * (r.u0 + r.u1), room.spec.max.y, r.v0 + 0.25}, 90.0}});
            }
        }
    }

    /// Links each opening to the opening of the other room that leads back.
    void link() {
        for (std::uint32_t c = 0; c < rooms_.size(); ++c) {
            for (std::size_t k = 0; k < rooms_[c].ways.size(); ++k) {
                const std::uint32_t to = rooms_[c].ways[k].to;
                if (to == CellLink::kOutside)
                    continue;
                const std::vector<Way>& theirs = rooms_[to].ways;
                const auto back =
                    std::find_if(theirs.begin(), theirs.end(), [&](const Way& w) { return w.to == c; });
                LIMEN_ASSERT(back != theirs.end(), "rooms are joined both ways");
                out_.plan.cells[c].links[k].portal = static_cast<std::uint16_t>(back - theirs.begin());
            }
        }
    }

    [[nodiscard]] double top() const { return s_.height + (s_.attic ? kAtticHeight : 0.0) + kWall; }

    /// Adds outer walls, seen from outside, with reveals to the openings in the walls' inner faces.
    void addWalls() {
        FaceMesh& mesh = out_.plan.exterior;
        std::vector<Face> portals;
        for (const Side side : {Side::West, Side::East, Side::South, Side::North}) {
            const bool alongY = side == Side::West || side == Side::East;
            const Rect whole = alongY ? Rect{0.0, s_.foot, s_.depth, top()}
                                      : Rect{-s_.halfWidth, s_.foot, s_.halfWidth, top()};
            std::vector<Rect> holes;
            for (const Opening& hole : holes_) {
                if (hole.side == side) {
                    holes.push_back(hole.rect);
                    addReveals(hole);
                }
            }
            for (const Rect& rect : withoutHoles(whole, holes))
                mesh.add(flipped(planarFace(rectOnSide(side, outerPlane(side), rect), Material::Plaster)));
        }
        for (const Opening& hole : holes_)
            portals.push_back(flipped(portalFace(rectOnSide(hole.side, innerPlane(hole.side), hole.rect))));
        for (Face& portal : portals)
            mesh.add(std::move(portal));
    }

    [[nodiscard]] double outerPlane(Side side) const {
        return side == Side::West    ? -s_.halfWidth
               : side == Side::East  ? s_.halfWidth
               : side == Side::South ? 0.0
                                     : s_.depth;
    }
    [[nodiscard]] double innerPlane(Side side) const {
        return side == Side::West    ? inner_.u0
               : side == Side::East  ? inner_.u1
               : side == Side::South ? inner_.v0
                                     : inner_.v1;
    }

    void addReveals(const Opening& hole) {
        const std::vector<Vec3> outer = rectOnSide(hole.side, outerPlane(hole.side), hole.rect);
        const std::vector<Vec3> inner = rectOnSide(hole.side, innerPlane(hole.side), hole.rect);
        const Vec3 middle = (outer[0] + inner[2]) * 0.5;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t j = (i + 1) % 4;
            out_.plan.exterior.polygon(facing({outer[i], outer[j], inner[j], inner[i]}, middle),
                                       Material::StoneWall);
        }
    }

    void addRoof() {
        constexpr double kOverhang = 0.375;
        const double rise = 0.75;
        const double ridge = top() + rise * s_.depth / 2;
        const double eaves = top() - rise * kOverhang;
        const double w = s_.halfWidth + kOverhang;
        FaceMesh& mesh = out_.plan.exterior;
        Face south = planarFace({{-w, -kOverhang, eaves},
                                 {w, -kOverhang, eaves},
                                 {w, s_.depth / 2, ridge},
                                 {-w, s_.depth / 2, ridge}},
                                Material::Thatch);
        Face north = planarFace({{w, s_.depth + kOverhang, eaves},
                                 {-w, s_.depth + kOverhang, eaves},
                                 {-w, s_.depth / 2, ridge},
                                 {w, s_.depth / 2, ridge}},
                                Material::Thatch);
        south.twoSided = north.twoSided = true;
        mesh.add(std::move(south));
        mesh.add(std::move(north));
        for (const double x : {-s_.halfWidth, s_.halfWidth}) {
            mesh.polygon(facing({{x, 0.0, top()}, {x, s_.depth, top()}, {x, s_.depth / 2, ridge}},
                                {3.0 * x, s_.depth / 2, top()}),
                         Material::OldPlanks);
        }
    }

    /// The exterior as in the built-in world, at random of stone or timber-framed.
    [[nodiscard]] HouseShell houseShell() const {
        Random random = apartFrom(random_);
        HouseShell shell;
        shell.halfWidth = s_.halfWidth;
        shell.depth = s_.depth;
        shell.wall = kWall;
        shell.base = s_.foot;
        shell.top = top();
        shell.pitch = 0.9;
        shell.ground = -kFloorUp;
        shell.timbered = random.chance(0.75);
        shell.walls = shell.timbered ? Material::Plaster : Material::StoneWall;
        shell.chimneyX = (random.chance(0.5) ? 1.0 : -1.0) * (s_.halfWidth - 0.9);
        shell.chimneyY = random.between(0.3, 0.45) * s_.depth;
        shell.upperFloor = s_.attic ? s_.height + kWall : 0.0;
        for (const Opening& hole : holes_)
            shell.holes.push_back({hole.side, hole.rect, hole.rect.v0 == 0.0});
        return shell;
    }

    const HouseSpec& s_;
    const Props& props_;
    Random& random_;
    Rect inner_; ///< of the walls, seen from above
    std::vector<Room> rooms_;
    std::vector<Opening> holes_; ///< through outer walls, in the order of the exits
    House out_;
};

} // namespace

HouseSpec randomHouse(Random& random, double foot) {
    HouseSpec spec;
    spec.halfWidth = 3.5 + 0.25 * random.below(7);
    spec.depth = 6.0 + 0.5 * random.below(7);
    spec.height = 2.5 + 0.25 * random.below(4);
    spec.foot = foot;
    spec.divided = random.chance(0.7);
    spec.cellar = random.chance(0.35);
    spec.attic = random.chance(0.35);
    return spec;
}

House planHouse(const HouseSpec& spec, const Props& props, Random& random) {
    return HousePlanner(spec, props, random).plan();
}

} // namespace limen::worlds
