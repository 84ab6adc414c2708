#include "check/views/Viewpoints.h"

#include "geometry/Tolerances.h"
#include "motion/Locate.h"

#include <algorithm>

namespace limen::check {

namespace {

constexpr int kTries = 64; // for a random viewpoint
// Directions in which a position is probed. The notch of a cell that winds around the position lets half of
// them pass.
constexpr int kProbes = 24;
constexpr double kRoom = 0.002;    // metres around a random eye: ten times kInPlaneTolerance
constexpr double kFar = 300.0;     // metres: length of a probe that ends in the sky
constexpr double kFromWall = 1e-4; // share of a probe's length that is left out before its end
constexpr double kIntoCell = 0.05; // metres before an opening: a point there is in its cell
constexpr double kAtEnd = 1e-7;    // share of a way: a surface this near to its end does not block it
static_assert(kRoom > 5.0 * kInPlaneTolerance);

/// True if the cell's tree contains the eye with room to spare. By its tolerance the tree alone would also
/// contain an eye a fraction of a millimetre behind a wall, or past an opening and so in the next cell. A
/// plane with all eight corners of a cube on its front is at least half the cube's side away.
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
        if (met.t < 1.0 - kAtEnd)
            return std::nullopt;
    }
    return motion::sweep(around.world, space, from, to);
}

bool isFreeViewpoint(const Surroundings& around, world::SpaceIndex space, const Vec3& eye,
                     RandomGenerator& random) {
    for (int i = 0; i < kProbes; ++i) {
        const Vec3 direction = random.direction();
        const reference::Answer seen = around.scene.trace(space, {eye, direction, 0.0});
        if (std::isnan(seen.t))
            continue; // a hole of the data proves nothing
        const double length = std::min(seen.t, kFar) * (1.0 - kFromWall);
        const reference::Answer back =
            around.scene.trace(seen.space, {eye + direction * length, -direction, 0.0});
        if (back.t < length * (1.0 - kFromWall))
            return false;
    }
    return true;
}

std::optional<Vec3> viewpointInCell(const Surroundings& around, world::SpaceIndex cell,
                                    RandomGenerator& random) {
    const world::Space& space = around.world.spaces[cell];
    const Vec3 size = space.bounds.max - space.bounds.min;
    for (int i = 0; i < kTries && !space.bounds.empty(); ++i) {
        const Vec3 eye = space.bounds.min + size * Vec3(random.unit(), random.unit(), random.unit());
        if (isWithin(around.world, cell, eye) && isFreeViewpoint(around, cell, eye, random))
            return eye;
    }
    // A cell with an empty tree: probe it from an opening.
    for (int i = 0; i < kTries && space.portalCount > 0; ++i) {
        const world::Portal& portal =
            around.world.portals[space.firstPortal + random.below(space.portalCount)];
        const Vec3 start = middleOf(around.world, portal) + portal.plane.n * kIntoCell;
        const Vec3 direction = random.direction();
        const reference::Answer seen = around.scene.trace(cell, {start, direction, 0.0});
        if (seen.space != cell || !std::isfinite(seen.t))
            continue;
        const Vec3 eye = start + direction * (seen.t * random.unit());
        if (isFreeViewpoint(around, cell, eye, random))
            return eye;
    }
    return std::nullopt;
}

Gaze gazeAlong(const Vec3& direction) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const double flat = std::hypot(direction.x, direction.y);
    const double yaw =
        flat > 1e-9 * std::abs(direction.z) ? std::atan2(direction.x, direction.y) * kDegrees : 0.0;
    return {yaw < 0.0 ? yaw + 360.0 : yaw + 0.0,
            std::atan2(direction.z, flat) * kDegrees + 0.0}; // + 0.0 turns -0 into 0
}

dat::RecordId cellIdOf(const world::World& world, world::SpaceIndex space) {
    return space == world::kOutside ? 0 : world.spaces[space].cellId;
}

} // namespace limen::check
