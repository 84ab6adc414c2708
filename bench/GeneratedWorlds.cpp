#include "GeneratedWorlds.h"

#include "TemporaryDirectory.h"

#include "dat/Archive.h"
#include "motion/Locate.h"
#include "world/Loader.h"
#include "world/Places.h"

#include <cmath>
#include <numbers>
#include <random>

namespace limen::bench {

namespace {

constexpr int kTries = 64; // attempts to find a suitable position
constexpr double kStandingEye = 1.7;

class RandomSeries {
public:
    explicit RandomSeries(std::uint32_t seed) : random_(seed) {}
    double between(double from, double to) { return from + (to - from) * unit_(random_); }
    std::size_t below(std::size_t count) {
        return std::min(static_cast<std::size_t>(unit_(random_) * static_cast<double>(count)), count - 1);
    }

private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

visibility::View lookAlong(const Vec3& eye, const Vec3& direction, world::SpaceIndex root) {
    visibility::View view;
    view.eye = eye;
    view.root = root;
    view.forward = glm::normalize(direction);
    view.right = glm::normalize(glm::cross(view.forward, Vec3(0, 0, 1)));
    view.up = glm::cross(view.right, view.forward);
    view.tanHalfX = 1.0;
    view.tanHalfY = std::tan(std::numbers::pi / 6.0);
    return view;
}

Vec3 anyDirection(RandomSeries& random, double steepest) {
    const double yaw = random.between(0.0, 2.0 * std::numbers::pi);
    return {std::sin(yaw), std::cos(yaw), random.between(-steepest, steepest)};
}

Vec3 middleOf(const world::World& world, const world::Portal& portal) {
    Vec3 sum(0.0);
    for (const Vec3& corner : cornersOf(world, portal))
        sum += corner;
    return sum / static_cast<double>(portal.cornerCount);
}

/// Collects up to `count` views from `next`. It stops early if `next` fails too often in a row.
template <class Next>
std::vector<visibility::View> collect(std::size_t count, Next next) {
    std::vector<visibility::View> views;
    for (std::size_t tries = 0; views.size() < count && tries < count * kTries; ++tries)
        next(views);
    return views;
}

const world::Portal& anyBuildingPortal(const world::World& world, RandomSeries& random) {
    const world::Space& outside = world.spaces[world::kOutside];
    return world.portals[outside.firstPortal + random.below(outside.portalCount)];
}

} // namespace

Result<world::World> generatedWorld(const worlds::GeneratedSpec& spec) {
    const TemporaryDirectory directory("bench");
    if (Result<void> written = worlds::writeGeneratedWorld(spec, directory.path()); !written)
        return Failure(written.error());
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    if (!archive)
        return Failure(archive.error());
    const Result<world::WorldFile> file = world::loadWorldFile(directory.path());
    if (!file)
        return Failure(file.error());
    if (file->places.empty())
        return fail(ErrorCode::NotFound, "generated world", "the world file names no place to load around");
    const world::Place& place = file->places.front();
    const dat::BlockCoord centre = place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye);
    return world::loadWorld(*archive, centre, {});
}

world::World apart(world::World world) {
    world.zones.clear();
    world.zoneSpaces.clear();
    for (world::SpaceIndex s = 0; s < world.spaces.size(); ++s) {
        world.spaces[s].zone = s;
        world.zones.push_back({s, 1});
        world.zoneSpaces.push_back(s);
    }
    return world;
}

std::vector<visibility::View> viewsInCells(const world::World& world, std::size_t count, std::uint32_t seed) {
    RandomSeries random(seed);
    return collect(count, [&](std::vector<visibility::View>& views) {
        const auto cell = static_cast<world::SpaceIndex>(1 + random.below(world.spaces.size() - 1));
        const Aabb& box = world.spaces[cell].bounds;
        for (int i = 0; i < kTries; ++i) {
            const Vec3 eye(random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y),
                           random.between(box.min.z, box.max.z));
            if (motion::cellContains(world, cell, eye)) {
                views.push_back(lookAlong(eye, anyDirection(random, 1.0), cell));
                return;
            }
        }
    });
}

std::vector<visibility::View> viewsOutdoors(const world::World& world, std::size_t count,
                                            std::uint32_t seed) {
    RandomSeries random(seed);
    return collect(count, [&](std::vector<visibility::View>& views) {
        const double turn = random.between(0.0, 2.0 * std::numbers::pi);
        Vec3 eye = middleOf(world, anyBuildingPortal(world, random)) +
                   Vec3(std::cos(turn), std::sin(turn), 0.0) * random.between(0.0, 25.0);
        eye.z = world::terrainHeight(world, eye.x, eye.y) + kStandingEye;
        if (isFinite(eye) && motion::locate(world, eye).space == world::kOutside)
            views.push_back(lookAlong(eye, anyDirection(random, 0.2), world::kOutside));
    });
}

std::vector<visibility::View> viewsAtWindows(const world::World& world, std::size_t count,
                                             std::uint32_t seed) {
    RandomSeries random(seed);
    return collect(count, [&](std::vector<visibility::View>& views) {
        const world::Portal& portal = anyBuildingPortal(world, random);
        const Vec3 out = portal.plane.n;
        const Vec3 eye = middleOf(world, portal) - out * random.between(0.3, 1.0);
        if (motion::cellContains(world, portal.destination, eye))
            views.push_back(lookAlong(eye, out + anyDirection(random, 0.2) * 0.3, portal.destination));
    });
}

} // namespace limen::bench
