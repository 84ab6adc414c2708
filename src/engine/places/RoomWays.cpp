#include "engine/places/RoomWays.h"

#include "engine/ViewRequest.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limen::engine {
namespace {

// Metres above the floor at which obstacles are looked for, from the knees to the eyes; lower ones are steps.
constexpr std::array kHeights{0.5, 0.7, 0.9, 1.1, 1.3, 1.5, kEyeHeight};
constexpr double kHalfBody = 0.3;     // metres, as of a body's capsule
constexpr double kStepHeight = 0.6;   // metres, as of a body
constexpr double kSampled = 0.4;      // metres between tests of the floor
constexpr double kBeyond = 0.15;      // metres behind a door's plane: the point is in the next cell
constexpr double kFarthestLook = 8.0; // metres walked into a room
constexpr double kNoWay = 1e300;
constexpr std::array kSquare{1.5, 1.2, 0.9,
                             0.6}; // metres from a door: beside its open leaf, the longest first

/// The eye just beyond an opening.
Vec3 beyond(const Opening& opening) {
    return opening.eye() - opening.inward * kBeyond;
}

bool isOpen(const CellShape& cell, const Vec3& from, const Vec3& to, const Vec3& offset) {
    return !cell.solids.blocks(from + offset, to + offset);
}

/// The opening of `cell` that leads back through `opening`; null if it is one-way.
const Opening* wayBack(const CellShape& cell, const Opening& opening) {
    return opening.otherPortal < cell.openings.size() ? &cell.openings[opening.otherPortal] : nullptr;
}

void append(const std::vector<Vec3>& eyes, dat::RecordId cell, std::vector<WayPoint>& out) {
    for (const Vec3& eye : eyes)
        out.push_back({eye, cell});
}

/// True if a body fits at an eye, from its knees upwards.
bool hasRoom(const CellShape& cell, const Vec3& eye) {
    constexpr int kDirections = 24; // 8 cm between them at the body's side: candlesticks are found
    for (const double height : kHeights)
        if (cell.solids.crowds(eye + Vec3(0.0, 0.0, height - kEyeHeight), kHalfBody, kDirections))
            return false;
    return true;
}

/// The eyes of bodies that fit into a cell.
std::vector<Vec3> stopsIn(const CellShape& cell) {
    std::vector<Vec3> stops = standingEyes(cell);
    std::erase_if(stops, [&](const Vec3& eye) { return !hasRoom(cell, eye); });
    return stops;
}

/// The way from an entry to the stop farthest from it; empty if no stop can be reached.
std::vector<Vec3> wayIntoRoom(const CellShape& cell, const Vec3& entry, const std::vector<Vec3>& stops) {
    std::vector<Vec3> order = stops;
    std::stable_sort(order.begin(), order.end(), [&](const Vec3& a, const Vec3& b) {
        return glm::length(a - entry) > glm::length(b - entry);
    });
    for (const Vec3& stop : order) {
        if (glm::length(stop - entry) > kFarthestLook)
            continue;
        std::vector<Vec3> way = wayInside(cell, entry, stop, stops);
        if (!way.empty())
            return way;
    }
    return {};
}

} // namespace

bool isWalkable(const CellShape& cell, const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double length = std::hypot(way.x, way.y);
    if (length < 1e-6)
        return std::abs(way.z) < kStepHeight;
    const Vec3 side = Vec3(-way.y, way.x, 0.0) * (kHalfBody / length);
    for (const double height : kHeights) {
        const Vec3 above(0.0, 0.0, height - kEyeHeight);
        for (const Vec3& offset : {above, above + side, above - side})
            if (!isOpen(cell, from, to, offset))
                return false;
    }
    // Both ends stand on a floor: their own or the sill of a door. Beside a sill the floor of the next cell
    // begins, so the ends are not tested.
    double feet = from.z - kEyeHeight;
    for (double metres = kSampled; metres < length - 0.2; metres += kSampled) {
        const Vec3 at = from + way * (metres / length);
        const double floor = cell.solids.floorBelow({at.x, at.y, feet + kStepHeight + 0.3}, 2.0);
        if (!(std::abs(floor - feet) <= kStepHeight))
            return false;
        feet = floor;
    }
    return std::abs(to.z - kEyeHeight - feet) <= kStepHeight + 0.1;
}

std::vector<Vec3> wayInside(const CellShape& cell, const Vec3& from, const Vec3& to,
                            const std::vector<Vec3>& stops) {
    if (isWalkable(cell, from, to))
        return {to};
    // Dijkstra's algorithm over from, the stops, and to.
    std::vector<Vec3> nodes{from};
    nodes.insert(nodes.end(), stops.begin(), stops.end());
    nodes.push_back(to);
    std::vector<double> cost(nodes.size(), kNoWay);
    std::vector<std::size_t> before(nodes.size(), 0);
    std::vector<bool> isDone(nodes.size(), false);
    cost[0] = 0.0;
    for (;;) {
        std::size_t next = nodes.size();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!isDone[i] && cost[i] < kNoWay && (next == nodes.size() || cost[i] < cost[next]))
                next = i;
        if (next == nodes.size())
            return {};
        if (next + 1 == nodes.size())
            break;
        isDone[next] = true;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const double through = cost[next] + glm::length(nodes[i] - nodes[next]);
            if (!isDone[i] && through < cost[i] && isWalkable(cell, nodes[next], nodes[i])) {
                cost[i] = through;
                before[i] = next;
            }
        }
    }
    std::vector<Vec3> way;
    for (std::size_t i = nodes.size() - 1; i != 0; i = before[i])
        way.push_back(nodes[i]);
    std::reverse(way.begin(), way.end());
    return way;
}

std::optional<Vec3> squareBehind(const CellShape& cell, const Opening& door) {
    const double flat = std::hypot(door.inward.x, door.inward.y);
    const Vec3 inward(door.inward.x / flat, door.inward.y / flat, 0.0);
    for (const double metres : kSquare) {
        const Vec3 at = door.eye() + inward * metres;
        const double floor = cell.solids.floorBelow(at, kEyeHeight + kStepHeight);
        const Vec3 eye(at.x, at.y, floor + kEyeHeight);
        if (std::isfinite(floor) && hasRoom(cell, eye) && isWalkable(cell, door.eye(), eye) &&
            isWalkable(cell, eye, door.eye()))
            return eye;
    }
    return {};
}

void roundThroughRooms(Shapes& shapes, dat::RecordId id, const Vec3& entry, std::size_t& rooms,
                       std::set<dat::RecordId>& visited, std::vector<WayPoint>& out) {
    const CellShape* cell = shapes.cell(id);
    if (cell == nullptr || rooms == 0 || !visited.insert(id).second)
        return;
    --rooms;
    const std::vector<Vec3> stops = stopsIn(*cell);
    Vec3 here = entry;
    if (const std::vector<Vec3> into = wayIntoRoom(*cell, entry, stops); !into.empty()) {
        append(into, id, out);
        here = into.back();
    }
    for (const Opening& opening : cell->openings) {
        const CellShape* next = opening.otherCell == 0 ? nullptr : shapes.cell(opening.otherCell);
        const Opening* back = next == nullptr ? nullptr : wayBack(*next, opening);
        if (back == nullptr || !opening.isDoor() || rooms == 0 || visited.contains(next->id))
            continue;
        const std::optional<Vec3> before = squareBehind(*cell, opening), after = squareBehind(*next, *back);
        const std::vector<Vec3> there = wayInside(*cell, here, before.value_or(opening.eye()), stops);
        const std::vector<Vec3> again = wayInside(*cell, before.value_or(beyond(*back)), here, stops);
        if (there.empty() || again.empty())
            continue;
        append(there, id, out);
        if (!before)
            out.pop_back();
        out.push_back({beyond(opening), next->id});
        if (after)
            out.push_back({*after, next->id});
        roundThroughRooms(shapes, next->id, after.value_or(beyond(opening)), rooms, visited, out);
        out.push_back({beyond(*back), id});
        if (before)
            out.push_back({*before, id});
        append(again, id, out);
    }
    if (here != entry)
        append(wayInside(*cell, here, entry, stops), id, out);
}

} // namespace limen::engine
