#include "worlds/generate/Furnish.h"

#include "worlds/generate/DungeonDoors.h"
#include "worlds/generate/DungeonShapes.h"

namespace limen::worlds {

namespace {

/// A piece of furniture whose back is to the north.
struct Piece {
    dat::RecordId model = 0;
    double half = 0.5;  ///< half its width, metres
    double depth = 0.5; ///< from the wall
    double back = 0.0;  ///< metres from its origin to its back
    bool tall = false;  ///< would cover a window
};

bool overlap(const Rect& a, const Rect& b) {
    return a.u0 < b.u1 && a.u1 > b.u0 && a.v0 < b.v1 && a.v1 > b.v0;
}

/// The part of the floor before a stretch of a wall.
Rect before(const RoomSpec& room, Side side, double from, double to, double depth) {
    switch (side) {
    case Side::West:
        return {room.min.x, from, room.min.x + depth, to};
    case Side::East:
        return {room.max.x - depth, from, room.max.x, to};
    case Side::South:
        return {from, room.min.y, to, room.min.y + depth};
    default:
        return {from, room.max.y - depth, to, room.max.y};
    }
}

class RoomFurnisher {
public:
    RoomFurnisher(std::vector<Furnishing>& statics, const RoomSpec& room, std::span<const Opening> openings,
                  Random random)
        : statics_(statics), room_(room), random_(random) {
        constexpr double kWay = 1.3, kSill = 0.5, kCorner = 1.2, kLedge = 0.8; // metres
        taken_.push_back({room.min.x, room.min.y, room.min.x + kCorner, room.min.y + kCorner});
        for (const auto& [side, r] : openings)
            if (side == Side::Floor || side == Side::Ceiling)
                taken_.push_back({r.u0 - 0.4, r.v0 - 0.4, r.u1 + 0.4, r.v1 + 0.4});
            else if (r.v0 < room.min.z + kSill)
                taken_.push_back(before(room, side, r.u0 - 0.15, r.u1 + 0.15, kWay));
            else
                windows_.push_back(before(room, side, r.u0 - 0.1, r.u1 + 0.1, kLedge));
    }

    void atWall(const Piece& piece) {
        for (int k = 0; k < kTries; ++k) {
            const auto turns = static_cast<int>(random_.below(4));
            constexpr std::array kSides{Side::North, Side::West, Side::South, Side::East};
            const Side side = kSides[static_cast<std::size_t>(turns)];
            const bool alongY = side == Side::West || side == Side::East;
            const double low = (alongY ? room_.min.y : room_.min.x) + piece.half + kGap;
            const double high = (alongY ? room_.max.y : room_.max.x) - piece.half - kGap;
            const double middle = random_.between(low, std::max(low, high));
            const Rect place =
                before(room_, side, middle - piece.half - kGap, middle + piece.half + kGap, piece.depth);
            if (high < low || !isFree(place, piece.tall))
                continue;
            taken_.push_back(place);
            const Placement wall{wallPoint(side, middle), 90.0 * turns};
            statics_.push_back(
                {piece.model, {worlds::place(wall, {0.0, -piece.back - kFromWall, 0.0}), wall.turn}});
            return;
        }
    }

    /// A table with a candle, and a chair at each long side.
    void table(const Furniture& f) {
        constexpr double kHalfX = 1.0, kHalfY = 1.1;
        for (int k = 0; k < kTries; ++k) {
            const double lowX = room_.min.x + kHalfX, highX = room_.max.x - kHalfX;
            const double lowY = room_.min.y + kHalfY, highY = room_.max.y - kHalfY;
            if (highX < lowX || highY < lowY)
                return;
            const double x = random_.between(lowX, highX), y = random_.between(lowY, highY);
            const Rect place{x - kHalfX, y - kHalfY, x + kHalfX, y + kHalfY};
            if (!isFree(place, false))
                continue;
            taken_.push_back(place);
            const Vec3 at(x, y, room_.min.z);
            statics_.push_back({f.table, {at, 0.0}});
            statics_.push_back({f.candle, {at + Vec3(random_.between(-0.4, 0.4), 0.1, 0.76), 0.0}});
            statics_.push_back({f.chair, {at + Vec3(-0.2, 0.62, 0.0), 0.0}});
            statics_.push_back({f.chair, {at + Vec3(0.25, -0.62, 0.0), 180.0}});
            return;
        }
    }

    /// A lantern near the middle of the ceiling, not before an eye in the middle.
    void lantern(dat::RecordId model) {
        const Vec3 middle = 0.5 * (room_.min + room_.max);
        const double x = random_.chance(0.5) ? 1.4 : -1.4;
        statics_.push_back({model, {{middle.x + x, middle.y + 0.6, room_.max.z}, 0.0}});
    }

private:
    static constexpr int kTries = 24;
    static constexpr double kGap = 0.05, kFromWall = 0.01; // metres

    [[nodiscard]] bool isFree(const Rect& place, bool tall) const {
        const auto hits = [&](const Rect& other) { return overlap(place, other); };
        return std::none_of(taken_.begin(), taken_.end(), hits) &&
               !(tall && std::any_of(windows_.begin(), windows_.end(), hits));
    }
    [[nodiscard]] Vec3 wallPoint(Side side, double middle) const {
        const double z = room_.min.z;
        return side == Side::West    ? Vec3(room_.min.x, middle, z)
               : side == Side::East  ? Vec3(room_.max.x, middle, z)
               : side == Side::South ? Vec3(middle, room_.min.y, z)
                                     : Vec3(middle, room_.max.y, z);
    }

    std::vector<Furnishing>& statics_;
    const RoomSpec& room_;
    Random random_;
    std::vector<Rect> taken_, windows_; ///< parts of the floor, seen from above
};

/// True if a form of room lacks the corner towards these signs of x and y.
bool lacksCorner(Form form, double x, double y) {
    return (form == Form::NoSouthWest && x < 0.0 && y < 0.0) ||
           (form == Form::NoSouthEast && x > 0.0 && y < 0.0) ||
           (form == Form::NoNorthWest && x < 0.0 && y > 0.0) ||
           (form == Form::NoNorthEast && x > 0.0 && y > 0.0);
}

/// The place of a dungeon room's light on the floor, beside the eye of its place.
Vec3 lightPoint(Form form) {
    constexpr double kAway = 2.0; // metres; every room is at least 6 m long and wide
    const Vec3 eye = eyePoint(form);
    switch (form) {
    case Form::Box:
    case Form::NoSouthEast:
        return {-kAway, kAway, 0.0};
    case Form::NoSouthWest:
        return {kAway, kAway, 0.0};
    case Form::NoNorthWest:
        return {kAway, -kAway, 0.0};
    case Form::NoNorthEast:
        return {-kAway, -kAway, 0.0};
    case Form::NoWest:
    case Form::NoEast:
        return {eye.x, kAway, 0.0};
    case Form::NoSouth:
    case Form::NoNorth:
        break;
    }
    return {kAway, eye.y, 0.0};
}

} // namespace

void furnishRoom(std::vector<Furnishing>& statics, const RoomSpec& room, std::span<const Opening> openings,
                 RoomUse use, const Props& props, Random random) {
    const Furniture& f = props.builtIn.house;
    const Piece shelf{f.shelf, 0.6, 0.4, 0.0, true}, bed{f.bed, 0.6, 2.15, 1.06, false},
        chest{f.chest, 0.55, 0.65, 0.33}, barrel{f.barrel, 0.37, 0.75, 0.37}, crate{f.crate, 0.4, 0.65, 0.31},
        sacks{f.sacks, 0.6, 1.1, 0.4};
    constexpr double kBreast = 2.5; // metres: the height of a fireplace with its chimney breast
    RoomFurnisher furnisher(statics, room, openings, random);
    switch (use) {
    case RoomUse::Living:
        if (room.max.z - room.min.z <= kBreast)
            furnisher.atWall({f.fireplace, 1.15, 1.1, 0.0, true});
        furnisher.table(f);
        for (const Piece& piece : {shelf, chest})
            furnisher.atWall(piece);
        break;
    case RoomUse::Sleeping:
        for (const Piece& piece : {bed, shelf, chest, barrel})
            furnisher.atWall(piece);
        break;
    case RoomUse::Storing:
        for (const Piece& piece : {barrel, barrel, crate, sacks, crate})
            furnisher.atWall(piece);
        break;
    }
    furnisher.lantern(f.lantern);
}

void furnishRoom(std::vector<Furnishing>& statics, const LatticeRoom& room, const Props& props,
                 Random random) {
    const DungeonProps& built = props.builtIn;
    const RoomSize& size = kRoomSizes[room.size];
    constexpr double kClear = 3.5; // metres: in wider walls, corners are clear of openings
    statics.push_back({random.chance(0.6) ? built.brazier : props.lamp, {lightPoint(room.form), 0.0}});
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
        constexpr double kTorchUp = 1.9, kFromCorner = 1.2, kPiece = 0.7; // metres
        const bool torch = random.chance(0.8), piece = random.chance(0.4);
        const std::array<dat::RecordId, 4> stores{built.house.barrel, built.house.crate, built.house.chest,
                                                  built.house.sacks};
        const dat::RecordId store = stores[random.below(4)];
        const double turn = random.between(-15.0, 15.0);
        if (lacksCorner(room.form, corner.x, corner.y))
            continue;
        // Light is computed at the corners of walls: a torch near one lights two walls.
        const Way way = corner.y < 0.0 ? Way::South : Way::North;
        if (torch && (size.halfX > kClear || room.doors[static_cast<std::size_t>(way)] == Door::None)) {
            statics.push_back({built.torch,
                               {{corner.x * (size.halfX - kFromCorner), corner.y * size.halfY, kTorchUp},
                                corner.y < 0.0 ? 180.0 : 0.0}});
        }
        if (piece)
            statics.push_back(
                {store, {{corner.x * (size.halfX - kPiece), corner.y * (size.halfY - kPiece), 0.0}, turn}});
    }
}

void furnishPassage(std::vector<Furnishing>& statics, const Passage& passage, double rise,
                    const Props& props) {
    constexpr double kUp = 1.5; // metres: up to here all passages have upright walls
    constexpr double kClear =
        1.6; // metres: beyond the leaf of an open door; light reaches corners from there
    constexpr double kTwoTorches = 9.0; // metres: a shorter passage has one torch
    double south = 1e9, north = -1e9;
    for (const Vec2& p : passageOutline(passage.door)) {
        south = std::min(south, p.x);
        north = std::max(north, p.x);
    }
    const auto torch = [&](double along, bool atNorth) {
        const Vec3 at(along, atNorth ? north : south, kUp + rise * along / passage.length);
        statics.push_back({props.builtIn.torch, {at, atNorth ? 0.0 : 180.0}});
    };
    torch(std::min(kClear, passage.length / 2), true);
    if (passage.length >= kTwoTorches)
        torch(passage.length - kClear, false);
}

} // namespace limen::worlds
