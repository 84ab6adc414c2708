#include "engine/places/Viewpoints.h"

#include "core/Assert.h"
#include "engine/Camera.h"
#include "engine/ViewRequest.h"
#include "geometry/Compass.h"
#include "geometry/ConvexPolygon.h"
#include "world/Lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limen::engine {
namespace {

constexpr double kFree = 1.0;        // metres around an eye outdoors
constexpr double kFreeInside = 0.35; // metres around an eye in a cell
constexpr double kSky = 60.0;        // metres above an eye outdoors without a roof
constexpr double kHighestStep = 3.0; // metres from the ground to a sill: stairs
constexpr double kOverGround = 0.3;  // metres that a line of sight stays above the ground
constexpr double kNearDoor = 0.05;   // metres before a door's plane
constexpr std::size_t kMostTried = 8;
constexpr std::array kDistances{8.0, 10.0, 6.5, 5.0, 13.0, 4.0};         // metres before a door
constexpr std::array kTurns{22.0, -22.0, 0.0, 38.0, -38.0, 55.0, -55.0}; // degrees off the door's axis
constexpr std::array kSides{200.0, 160.0, 240.0, 120.0,
                            280.0, 80.0,  0.0}; // degrees, a building without doors

Vec3 level(const Vec3& direction) {
    const double length = std::hypot(direction.x, direction.y);
    return length > 0.0 ? Vec3(direction.x / length, direction.y / length, 0.0) : Vec3(0.0, 1.0, 0.0);
}

bool isOverGround(Shapes& shapes, const Vec3& from, const Vec3& to) {
    constexpr int kSteps = 6;
    for (int i = 0; i < kSteps; ++i) { // the end may be on the ground
        const Vec3 at = from + (to - from) * (static_cast<double>(i) / kSteps);
        if (!(at.z > shapes.ground(at.x, at.y) + kOverGround))
            return false;
    }
    return true;
}

/// A standing eye at (x, y) if it is in free space outdoors and sees `target`.
std::optional<world::Place> eyeOutdoors(Shapes& shapes, const BlockShape& block, const Vec3& at,
                                        const Vec3& target, double reach) {
    const double ground = shapes.ground(at.x, at.y);
    if (!std::isfinite(ground))
        return {};
    world::Place place;
    place.eye = {at.x, at.y, ground + kEyeHeight};
    const Vec3 end = place.eye + (target - place.eye) * reach;
    if (!isOverGround(shapes, place.eye, end))
        return {};
    const dat::BlockCoord own = world::blockAt(place.eye);
    for (const BlockShape* around : {&block, own == block.coord ? nullptr : &shapes.block(own)}) {
        if (around == nullptr)
            continue;
        const Obstacles& solids = around->solids;
        if (solids.blocks(place.eye, end) || solids.blocks({at.x, at.y, ground + 0.05}, place.eye) ||
            solids.blocks(place.eye, place.eye + Vec3(0.0, 0.0, kSky)) || solids.crowds(place.eye, kFree))
            return {};
    }
    lookAt(place, target);
    return place;
}

} // namespace

void lookAt(world::Place& place, const Vec3& target) {
    const Vec3 way = target - place.eye;
    if (glm::length(way) < 1e-6)
        return;
    const Heading heading = headingOf(way);
    place.yaw = std::round(heading.yaw * 10.0) / 10.0; // tenths of a degree read well in a list
    place.pitch = std::round(heading.pitch * 10.0) / 10.0;
}

std::vector<FrontDoor> frontDoors(Shapes& shapes, const BlockShape& block, std::size_t building) {
    LIMEN_ASSERT(building < block.buildings.size(), "a building of the block");
    std::vector<FrontDoor> doors;
    for (const dat::BuildingPortal& portal : block.buildings[building].record.portals) {
        const dat::RecordId id = dat::blockWord(block.coord) | portal.otherCellId;
        const CellShape* cell = shapes.cell(id);
        if (cell == nullptr || portal.otherPortalId >= cell->openings.size())
            continue;
        const Opening& opening = cell->openings[portal.otherPortalId];
        if (opening.otherCell != 0 || !opening.isDoor())
            continue;
        const Vec3 front = opening.middle - level(opening.inward) * 2.0;
        const double step = opening.sill - shapes.ground(front.x, front.y);
        if (std::abs(step) <= kHighestStep) // false for NaN
            doors.push_back({building, id, portal.otherPortalId, step});
    }
    const auto rank = [&](const FrontDoor& door) {
        const Opening& opening = shapes.cell(door.cell)->openings[door.opening];
        return std::abs(door.step) - 0.2 * opening.width * opening.height;
    };
    std::stable_sort(doors.begin(), doors.end(),
                     [&](const FrontDoor& a, const FrontDoor& b) { return rank(a) < rank(b); });
    return doors;
}

std::optional<world::Place> beforeDoor(Shapes& shapes, const BlockShape& block, const FrontDoor& door) {
    const CellShape* cell = shapes.cell(door.cell);
    LIMEN_ASSERT(cell != nullptr && door.opening < cell->openings.size(), "a door that frontDoors found");
    const Opening& opening = cell->openings[door.opening];
    const Vec3 outward = level(-opening.inward);
    const Vec3 target = opening.eye() + outward * kNearDoor;
    for (const double distance : kDistances) {
        for (const double turn : kTurns) {
            const Vec3 at = target + turnedTo(turn) * outward * distance;
            if (std::optional<world::Place> place = eyeOutdoors(shapes, block, at, target, 1.0)) {
                // The gaze ends above the lintel: the picture shows the front, and less of the ground.
                lookAt(*place, target + Vec3(0.0, 0.0, 0.6));
                return place;
            }
        }
    }
    return {};
}

std::optional<world::Place> beforeBuilding(Shapes& shapes, const BlockShape& block, std::size_t building) {
    LIMEN_ASSERT(building < block.buildings.size(), "a building of the block");
    const BuildingShape& shape = block.buildings[building];
    if (shape.bounds.empty())
        return {};
    const Vec3 half = (shape.bounds.max - shape.bounds.min) * 0.5;
    const double radius = std::hypot(half.x, half.y);
    for (const double beyond : {10.0, 18.0, 6.0}) {
        for (const double side : kSides) {
            const Vec3 at = shape.middle + turnedTo(side) * Vec3(0.0, radius + beyond, 0.0);
            const double ground = shapes.ground(at.x, at.y);
            const Vec3 target(shape.middle.x, shape.middle.y, std::max(shape.middle.z, ground + kEyeHeight));
            // Free up to the box around the exterior, which the line then meets.
            if (auto place = eyeOutdoors(shapes, block, at, target, beyond * 0.9 / (radius + beyond)))
                return place;
        }
    }
    return {};
}

std::optional<world::Place> beforeNearestBuilding(Shapes& shapes, const BlockShape& block, const Vec3& near) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < block.buildings.size(); ++i)
        order.push_back(i);
    const auto distance = [&](std::size_t i) {
        const Vec3 way = block.buildings[i].middle - near;
        return std::hypot(way.x, way.y);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    order.resize(std::min(order.size(), kMostTried));
    for (const std::size_t building : order)
        for (const FrontDoor& door : frontDoors(shapes, block, building))
            if (std::optional<world::Place> place = beforeDoor(shapes, block, door))
                return place;
    for (const std::size_t building : order)
        if (std::optional<world::Place> place = beforeBuilding(shapes, block, building))
            return place;
    return {};
}

std::optional<world::Place> aboveGround(Shapes& shapes, double x, double y) {
    const double ground = shapes.ground(x, y);
    if (!std::isfinite(ground))
        return {};
    world::Place place;
    place.eye = {x, y, ground + kEyeHeight};
    double lowest = 1e300;
    for (int i = 0; i < 8; ++i) {
        double highest = -1e300; // the steepest line of sight in this direction
        for (const double metres : {15.0, 30.0, 60.0, 120.0}) {
            const Vec3 at = place.eye + turnedTo(i * 45.0) * Vec3(0.0, metres, 0.0);
            const double there = shapes.ground(at.x, at.y);
            highest = std::max(highest, std::isfinite(there) ? (there - place.eye.z) / metres : 1.0);
        }
        if (highest < lowest) {
            lowest = highest;
            place.yaw = i * 45.0;
        }
    }
    return place;
}

std::vector<Vec3> standingEyes(const CellShape& cell) {
    constexpr double kLeastFloor = 0.3;     // square metres
    constexpr std::size_t kMostEyes = 40;   // per cell
    constexpr double kTowardsCorner = 0.55; // share of the way from a floor's middle
    std::vector<Vec3> eyes;
    const auto consider = [&](const Vec3& foot) {
        const Vec3 eye = foot + Vec3(0.0, 0.0, kEyeHeight);
        const Vec3 low = foot + Vec3(0.0, 0.0, 0.05), high = eye + Vec3(0.0, 0.0, 0.15);
        if (eyes.size() >= kMostEyes || cell.solids.blocks(low, high) || cell.solids.crowds(eye, kFreeInside))
            return;
        // The eye must be in this cell: no horizontal opening between feet and eye.
        for (const Opening& opening : cell.openings) {
            Obstacles pane;
            std::vector<Triangle> triangles;
            addFan(opening.outline, triangles);
            pane.add(std::move(triangles));
            if (pane.blocks(low, high))
                return;
        }
        eyes.push_back(eye);
    };
    for (const std::vector<Vec3>& wall : cell.walls) {
        const Vec3 normal = newellNormal(wall);
        const double twice = glm::length(normal);
        if (twice < 2.0 * kLeastFloor || normal.z < 0.7 * twice)
            continue;
        Vec3 middle(0.0);
        for (const Vec3& corner : wall)
            middle += corner / static_cast<double>(wall.size());
        consider(middle);
        for (const Vec3& corner : wall)
            if (glm::length(corner - middle) > 1.5)
                consider(middle + (corner - middle) * kTowardsCorner);
    }
    return eyes;
}

namespace {

/// For cells without room to stand, such as shafts: the middle, if a free line leads there from an opening.
std::optional<CellViewpoint> afloat(const CellShape& cell) {
    Vec3 middle(0.0);
    double count = 0.0;
    for (const std::vector<Vec3>& wall : cell.walls) {
        for (const Vec3& corner : wall) {
            middle += corner;
            count += 1.0;
        }
    }
    if (count == 0.0)
        return {};
    middle /= count;
    for (const Opening& opening : cell.openings) {
        const Vec3 target = opening.middle + opening.inward * kNearDoor;
        if (opening.inward == Vec3(0.0) || glm::dot(middle - opening.middle, opening.inward) <= kNearDoor ||
            cell.solids.blocks(middle, target) || cell.solids.crowds(middle, 0.15))
            continue;
        CellViewpoint viewpoint{{{}, middle, 0.0, 0.0, cell.id}, 0.0};
        lookAt(viewpoint.place, target);
        return viewpoint;
    }
    return {};
}

} // namespace

std::optional<CellViewpoint> insideCell(const CellShape& cell) {
    std::optional<CellViewpoint> best;
    const std::vector<Vec3> eyes = standingEyes(cell);
    for (const Vec3& eye : eyes) {
        for (const Opening& opening : cell.openings) {
            const Vec3 target = opening.middle + opening.inward * kNearDoor;
            const double distance = glm::length(target - eye);
            if (!opening.isDoor() || distance < 1.0 || cell.solids.blocks(eye, target))
                continue;
            const double score =
                std::min(distance, 9.0) + std::min(opening.width * opening.height, 9.0) * 0.5;
            if (!best || score > best->score) {
                best = {{{}, eye, 0.0, 0.0, cell.id}, score};
                lookAt(best->place, {target.x, target.y, std::min(opening.eye().z, eye.z + 1.0)});
            }
        }
    }
    for (const Vec3& eye : best ? std::vector<Vec3>() : eyes) { // a cell without doors: the longest view
        for (int i = 0; i < 8; ++i) {
            const Vec3 way = turnedTo(i * 45.0) * Vec3(0.0, 20.0, 0.0);
            const double score = cell.solids.freeShare(eye, eye + way);
            if (!best || score > best->score)
                best = {{{}, eye, i * 45.0, 0.0, cell.id}, score};
        }
    }
    return best ? best : afloat(cell);
}

} // namespace limen::engine
