#include "engine/places/MadeTour.h"

#include "engine/ViewRequest.h"
#include "engine/places/RoomWays.h"
#include "engine/places/WalkGrid.h"
#include "geometry/Compass.h"
#include "world/Lookup.h"

#include <algorithm>
#include <cmath>

namespace limen::engine {
namespace {

constexpr std::size_t kEntered = 3;       // buildings whose rooms are visited
constexpr std::size_t kPassed = 8;        // buildings whose doors are visited
constexpr std::size_t kRooms = 6;         // cells of one building
constexpr std::size_t kDungeonRooms = 14; // cells of the dungeon
constexpr double kBeforeDoor = 2.5;       // metres from a door to the point where the way in begins
constexpr double kFrontReach = 3.0;       // metres from there to an open square
constexpr double kStep = 0.6;             // metres, as of a body
constexpr double kSample = 0.3;           // metres between tests of the floor

double levelMetres(const Vec3& a, const Vec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The eyes of a walk on the surfaces outdoors from an eye to a door's sill, without the ends. None: a step
/// is too high, or something is in the way.
std::optional<std::vector<Vec3>> wayToSill(Shapes& shapes, const BlockShape& block, const Vec3& from,
                                           const Opening& door) {
    const Vec3 to = door.eye() - door.inward * 0.1;
    const double length = levelMetres(from, to);
    std::vector<Vec3> eyes;
    double feet = from.z - kEyeHeight;
    Vec3 last = from;
    for (double metres = kSample; metres < length; metres += kSample) {
        const Vec3 at = from + (to - from) * (metres / length);
        const double surface = block.solids.floorBelow({at.x, at.y, feet + kStep + 0.3}, 2.5);
        const double floor = std::fmax(surface, shapes.ground(at.x, at.y));
        if (!(std::abs(floor - feet) <= kStep))
            return {};
        feet = floor;
        const Vec3 eye(at.x, at.y, floor + kEyeHeight);
        if (block.solids.blocks(last, eye))
            return {};
        if (std::abs(floor + kEyeHeight - (from.z + (to.z - from.z) * (metres / length))) > 0.25)
            eyes.push_back(eye);
        last = eye;
    }
    if (std::abs(door.sill - feet) > kStep || block.solids.blocks(last, to))
        return {};
    return eyes;
}

/// Makes one tour.
class TourMaker {
public:
    explicit TourMaker(Shapes& shapes) : shapes_(shapes) {}

    void town(const world::Place& start) {
        points_.push_back({start.eye, 0});
        const BlockShape& block = shapes_.block(world::blockAt(start.eye));
        std::vector<FrontDoor> doors;
        for (std::size_t i = 0; i < block.buildings.size(); ++i)
            if (const std::vector<FrontDoor> all = frontDoors(shapes_, block, i); !all.empty())
                doors.push_back(all.front());
        if (doors.empty() && block.buildings.empty())
            return land(start.eye);
        const WalkGrid grid(shapes_, block, doors);
        std::size_t entered = 0, passed = 0;
        while (!doors.empty() && passed++ < kPassed) {
            const auto next =
                std::min_element(doors.begin(), doors.end(), [&](const FrontDoor& a, const FrontDoor& b) {
                    return levelMetres(openingOf(a).middle, points_.back().eye) <
                           levelMetres(openingOf(b).middle, points_.back().eye);
                });
            const FrontDoor door = *next;
            doors.erase(next);
            if (visit(grid, block, door, entered < kEntered))
                ++entered;
        }
        if (points_.size() == 1) // no door can be reached
            return land(start.eye);
        for (const Vec3& eye : grid.way(points_.back().eye, start.eye))
            points_.push_back({eye, 0});
    }

    /// A round on the ground, around obstacles. Requires a first point.
    void land(const Vec3& start) {
        for (const double radius : {20.0, 45.0}) {
            for (int i = 0; i <= 8; ++i) {
                const Vec3 at = start + turnedTo(i * 45.0) * Vec3(0.0, radius, 0.0);
                const double ground = shapes_.ground(at.x, at.y);
                const Vec3 eye(at.x, at.y, ground + kEyeHeight);
                if (std::isfinite(ground) && isFreeOutdoors(points_.back().eye, eye))
                    points_.push_back({eye, 0});
            }
        }
    }

    void dungeon(const world::Place& place, std::size_t rooms) {
        points_.push_back({place.eye, place.cell});
        std::set<dat::RecordId> visited;
        roundThroughRooms(shapes_, place.cell, place.eye, rooms, visited, points_);
    }

    /// The way points, each with the heading of the way after it.
    std::vector<world::Place> finish(const std::vector<world::Place>& places) const {
        std::vector<world::Place> tour;
        for (const WayPoint& point : points_) {
            if (!tour.empty() && tour.back().cell == point.cell &&
                glm::length(tour.back().eye - point.eye) < 0.05)
                continue;
            tour.push_back({{}, point.eye, 0.0, 0.0, point.cell});
        }
        for (std::size_t i = 0; i < tour.size(); ++i) {
            const auto given = std::find_if(places.begin(), places.end(),
                                            [&](const world::Place& p) { return p.eye == tour[i].eye; });
            if (given != places.end()) {
                tour[i].yaw = given->yaw;
                tour[i].pitch = given->pitch;
            } else if (i + 1 < tour.size() && levelMetres(tour[i].eye, tour[i + 1].eye) > 0.01 &&
                       !world::isJump(tour[i], tour[i + 1])) {
                world::Place ahead = tour[i];
                lookAt(ahead, tour[i + 1].eye);
                tour[i].yaw = ahead.yaw;
            } else if (i > 0) {
                tour[i].yaw = tour[i - 1].yaw;
            }
        }
        return tour;
    }

private:
    /// True if a line between two points outdoors meets no object and no ground.
    [[nodiscard]] bool isFreeOutdoors(const Vec3& from, const Vec3& to) {
        constexpr int kSteps = 12;
        for (int i = 0; i <= kSteps; ++i) {
            const Vec3 at = from + (to - from) * (static_cast<double>(i) / kSteps);
            if (!(at.z > shapes_.ground(at.x, at.y) + 0.3)) // false for NaN
                return false;
        }
        const Vec3 knee(0.0, 0.0, 0.5 - kEyeHeight);
        for (const Vec3& end : {from, to}) {
            const Obstacles& solids = shapes_.block(world::blockAt(end)).solids;
            if (solids.blocks(from, to) || solids.blocks(from + knee, to + knee))
                return false;
        }
        return true;
    }

    const Opening& openingOf(const FrontDoor& door) const {
        return shapes_.cell(door.cell)->openings[door.opening];
    }

    /// Walks to the front of a door and, if wanted and possible, through the rooms behind it. True if it
    /// entered.
    bool visit(const WalkGrid& grid, const BlockShape& block, const FrontDoor& door, bool enters) {
        const Opening& opening = openingOf(door);
        const double flat = std::hypot(opening.inward.x, opening.inward.y);
        const Vec3 inward = Vec3(opening.inward.x, opening.inward.y, 0.0) / flat;
        const std::optional<Vec3> front = grid.openNear(opening.middle - inward * kBeforeDoor, kFrontReach);
        if (!front)
            return false;
        const std::vector<Vec3> way = grid.way(points_.back().eye, *front);
        for (const Vec3& eye : way)
            points_.push_back({eye, 0});
        if (way.empty() || !enters)
            return false;
        // Square before the door, or at least from the front's open square.
        const std::optional<std::vector<Vec3>> steps = wayToSill(shapes_, block, *front, opening);
        if (!steps)
            return false;
        const Vec3 inside = opening.eye() + opening.inward * 0.15;
        std::vector<WayPoint> rooms;
        std::size_t most = kRooms;
        std::set<dat::RecordId> visited;
        const std::optional<Vec3> square = squareBehind(*shapes_.cell(door.cell), opening);
        roundThroughRooms(shapes_, door.cell, square.value_or(inside), most, visited, rooms);
        if (rooms.empty())
            return false;
        for (const Vec3& eye : *steps)
            points_.push_back({eye, 0});
        points_.push_back({inside, door.cell});
        if (square)
            points_.push_back({*square, door.cell});
        points_.insert(points_.end(), rooms.begin(), rooms.end());
        points_.push_back({opening.eye() - opening.inward * 0.15, 0});
        for (auto eye = steps->rbegin(); eye != steps->rend(); ++eye)
            points_.push_back({*eye, 0});
        points_.push_back({*front, 0});
        return true;
    }

    Shapes& shapes_;
    std::vector<WayPoint> points_;
};

} // namespace

std::vector<world::Place> makeTour(Shapes& shapes, const std::optional<world::Place>& start,
                                   const std::optional<world::Place>& dungeon) {
    if (!start)
        return {};
    TourMaker maker(shapes);
    if (start->cell != 0) {
        maker.dungeon(*start, 2 * kDungeonRooms);
        return maker.finish({*start});
    }
    maker.town(*start);
    if (!dungeon)
        return maker.finish({*start});
    maker.dungeon(*dungeon, kDungeonRooms);
    return maker.finish({*start, *dungeon});
}

} // namespace limen::engine
