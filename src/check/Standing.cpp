#include "check/Standing.h"

#include "motion/Locate.h"

#include <algorithm>

namespace limen::check {

namespace {

constexpr int kTriesToStand = 64; // for a random place
// Directions that a place is felt out in. The notch of a cell that winds around one lets half of them pass.
constexpr int kFeelers = 24;
constexpr double kRoom =
    0.002; // metres around a random eye: more than the trees' slack and the rule's tolerance
constexpr double kFar = 300.0;     // metres: where a feeler into the sky is walked back from
constexpr double kFromWall = 1e-4; // share of a feeler's length that is left out before its end
constexpr double kIntoCell = 0.05; // metres before an opening that are surely in its cell

/// True if the cell's tree holds the eye with room to spare. By its slack the tree alone would also let in an eye a fraction
/// of a millimetre behind a wall, or past an opening and so in the next cell. Planes that leave out none of the eight corners
/// of a cube are at least its half side away.
bool isWithin(const world::World& world, world::SpaceIndex cell, const Vec3& eye) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 way((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
        if (!motion::cellContains(world, cell, eye + way * kRoom))
            return false;
    }
    return true;
}

} // namespace

std::vector<world::SpaceIndex> cellsOf(const world::World& world, dat::BlockCoord block) {
    std::vector<world::SpaceIndex> cells;
    for (world::SpaceIndex s = 1; s < world.spaces.size(); ++s)
        if (dat::blockOf(world.spaces[s].cellId) == block)
            cells.push_back(s);
    return cells;
}

std::vector<world::PortalIndex> openingsOf(const world::World& world, dat::BlockCoord block) {
    std::vector<world::PortalIndex> openings;
    for (const world::SpaceIndex cell : cellsOf(world, block)) {
        const world::Space& space = world.spaces[cell];
        for (world::PortalIndex p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const world::Portal& portal = world.portals[p];
            const bool second = portal.reciprocal != world::kNone && portal.destination != world::kOutside &&
                                portal.reciprocal < p;
            if (portal.destination != world::kNone && !second && portal.plane.n != Vec3(0.0))
                openings.push_back(p);
        }
    }
    return openings;
}

Vec3 middleOf(const world::World& world, const world::Portal& portal) {
    const std::span<const Vec3> corners = cornersOf(world, portal);
    Vec3 sum(0.0);
    for (const Vec3& corner : corners)
        sum += corner;
    return sum / static_cast<double>(corners.size());
}

std::optional<world::SpaceIndex> walk(const Surroundings& around, world::SpaceIndex space, const Vec3& from,
                                      const Vec3& to) {
    if (from != to) {
        const reference::Answer met = around.scene.trace(space, {from, to - from, 0.0});
        if (met.t < 1.0 - 1e-7)
            return std::nullopt;
    }
    return motion::sweep(around.world, space, from, to);
}

bool standsFree(const Surroundings& around, world::SpaceIndex space, const Vec3& eye,
                RandomGenerator& random) {
    for (int i = 0; i < kFeelers; ++i) {
        const Vec3 direction = random.direction();
        const reference::Answer seen = around.scene.trace(space, {eye, direction, 0.0});
        if (std::isnan(seen.t))
            continue; // a hole of the data says nothing
        const double length = std::min(seen.t, kFar) * (1.0 - kFromWall);
        const reference::Answer back =
            around.scene.trace(seen.space, {eye + direction * length, -direction, 0.0});
        if (back.t < length * (1.0 - kFromWall))
            return false;
    }
    return true;
}

std::optional<Vec3> placeInCell(const Surroundings& around, world::SpaceIndex cell, RandomGenerator& random) {
    const world::Space& space = around.world.spaces[cell];
    const Vec3 size = space.bounds.max - space.bounds.min;
    for (int i = 0; i < kTriesToStand && !space.bounds.empty(); ++i) {
        const Vec3 eye = space.bounds.min + size * Vec3(random.unit(), random.unit(), random.unit());
        if (isWithin(around.world, cell, eye) && standsFree(around, cell, eye, random))
            return eye;
    }
    // A cell whose tree holds nothing: feel the way in from an opening.
    for (int i = 0; i < kTriesToStand && space.portalCount > 0; ++i) {
        const world::Portal& portal =
            around.world.portals[space.firstPortal + random.below(space.portalCount)];
        const Vec3 start = middleOf(around.world, portal) + portal.plane.n * kIntoCell;
        const Vec3 direction = random.direction();
        const reference::Answer seen = around.scene.trace(cell, {start, direction, 0.0});
        if (seen.space != cell || !std::isfinite(seen.t))
            continue;
        const Vec3 eye = start + direction * (seen.t * random.unit());
        if (standsFree(around, cell, eye, random))
            return eye;
    }
    return std::nullopt;
}

Gaze gazeAlong(const Vec3& direction) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const double flat = std::hypot(direction.x, direction.y);
    const double yaw =
        flat > 1e-9 * std::abs(direction.z) ? std::atan2(direction.x, direction.y) * kDegrees : 0.0;
    return {yaw < 0.0 ? yaw + 360.0 : yaw + 0.0, std::atan2(direction.z, flat) * kDegrees + 0.0}; // no "-0"
}

dat::RecordId cellIdOf(const world::World& world, world::SpaceIndex space) {
    return space == world::kOutside ? 0 : world.spaces[space].cellId;
}

} // namespace limen::check
