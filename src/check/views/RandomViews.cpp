#include "check/views/Viewpoints.h"

#include "motion/Locate.h"
#include "world/Loader.h"

#include <algorithm>

namespace limen::check {

namespace {

constexpr int kTriesOfView = 40;

/// A random gaze, sometimes straight up or down.
Gaze anyGaze(RandomGenerator& random) {
    const double pitch =
        random.unit() < 0.04 ? (random.unit() < 0.5 ? -90.0 : 90.0) : random.between(-75.0, 75.0);
    return {random.between(0.0, 360.0), pitch};
}

View lookFrom(const Surroundings& around, ViewKind kind, const Vec3& eye, const Gaze& gaze, double fov,
              world::SpaceIndex root) {
    View view;
    view.kind = kind;
    view.eye = eye;
    view.yaw = gaze.yaw;
    view.pitch = gaze.pitch;
    view.fov = fov;
    view.width = around.width;
    view.height = around.height;
    view.root = cellIdOf(around.world, root);
    return view;
}

/// The block's building portals.
std::vector<world::PortalIndex> doorsOf(const world::World& world, dat::BlockCoord block) {
    std::vector<world::PortalIndex> doors = openingsOf(world, block);
    std::erase_if(doors,
                  [&](world::PortalIndex p) { return world.portals[p].destination != world::kOutside; });
    return doors;
}

/// A random position above the block's ground; near `door` if it is not null. NaN height where there is no
/// ground.
Vec3 placeAboveGround(const Surroundings& around, const world::Portal* door, RandomGenerator& random) {
    Vec3 eye = Vec3(around.block.x, around.block.y, 0.0) * world::kBlockSize +
               Vec3(random.unit(), random.unit(), 0.0) * world::kBlockSize;
    if (door != nullptr) {
        const double turn = random.between(0.0, 2.0 * std::numbers::pi), far = random.betweenLog(0.2, 20.0);
        eye = middleOf(around.world, *door) + Vec3(std::cos(turn), std::sin(turn), 0.0) * far;
    }
    eye.z = world::terrainHeight(around.world, eye.x, eye.y) + random.betweenLog(0.3, 20.0);
    return eye;
}

} // namespace

void addRandomViews(const Surroundings& around, ViewKind kind, std::size_t count, std::vector<View>& out) {
    const std::vector<world::SpaceIndex> cells = cellsOf(around.world, around.block);
    for (std::size_t i = 0; i < count && !cells.empty(); ++i) {
        RandomGenerator random(around.seed,
                               {static_cast<std::uint64_t>(kind), dat::blockWord(around.block), i});
        const world::SpaceIndex cell = cells[(i + random.below(2)) % cells.size()];
        const std::optional<Vec3> eye = viewpointInCell(around, cell, random);
        if (eye)
            out.push_back(lookFrom(around, kind, *eye, anyGaze(random), random.between(40.0, 100.0), cell));
    }
}

void addOutsideViews(const Surroundings& around, std::size_t count, std::vector<View>& out) {
    const std::vector<world::PortalIndex> doors = doorsOf(around.world, around.block);
    for (std::size_t i = 0; i < count; ++i) {
        RandomGenerator random(
            around.seed, {static_cast<std::uint64_t>(ViewKind::Outside), dat::blockWord(around.block), i});
        for (int attempt = 0; attempt < kTriesOfView; ++attempt) {
            const world::Portal* door = doors.empty() || random.unit() < 0.4
                                            ? nullptr
                                            : &around.world.portals[doors[random.below(doors.size())]];
            const Vec3 eye = placeAboveGround(around, door, random);
            if (!isFinite(eye) || world::blockAt(eye) != around.block ||
                motion::locate(around.world, eye).space != world::kOutside ||
                !isFreeViewpoint(around, world::kOutside, eye, random))
                continue;
            const bool atDoor = door != nullptr && random.unit() < 0.5;
            const Gaze gaze = atDoor ? gazeAlong(middleOf(around.world, *door) - eye) : anyGaze(random);
            out.push_back(
                lookFrom(around, ViewKind::Outside, eye, gaze, random.between(40.0, 100.0), world::kOutside));
            break;
        }
    }
}

} // namespace limen::check
