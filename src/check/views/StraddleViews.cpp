#include "check/views/Viewpoints.h"

#include "geometry/Tolerances.h"
#include "world/Lookup.h"

#include <fmt/format.h>

namespace limen::check {

namespace {

constexpr double kLeastOff = 1e-6, kMostOff = 1e-2; // metres from a plane, an edge or a corner
constexpr int kTriesOfStraddle = 24;
/// Metres before or behind the opening, and inside its edges: a point from which the eye is walked to.
constexpr double kStartOff = 0.02;

/// A point inside the opening: anywhere, near an edge, or near a corner.
Vec3 pointInOpening(const world::World& world, const world::Portal& portal, RandomGenerator& random) {
    const Vec3 middle = middleOf(world, portal);
    const std::span<const Vec3> corners = cornersOf(world, portal);
    const std::size_t i = random.below(corners.size());
    const Vec3 &corner = corners[i], &next = corners[(i + 1) % corners.size()];
    const std::size_t where = random.below(5);
    if (where == 0)
        return corner + (middle - corner) * random.between(0.2, 1.0);
    const Vec3 on = where < 3 ? corner + (next - corner) * random.between(0.05, 0.95) : corner;
    const double length = glm::length(middle - on);
    return length > 0.0 ? on + (middle - on) * (random.betweenLog(kLeastOff, kMostOff) / length) : on;
}

/// Along the plane, near it, or any way.
Vec3 gazeAtPlane(const Vec3& n, RandomGenerator& random) {
    const Vec3 any = random.direction();
    const Vec3 flat = any - n * glm::dot(any, n);
    const std::size_t where = random.below(4);
    if (where == 0 || glm::length(flat) < 0.1)
        return any;
    const double tilt = where == 1 ? 0.0 : random.betweenLog(1e-5, 0.3) * (where == 2 ? 1.0 : -1.0);
    return glm::normalize(flat) + n * tilt;
}

std::optional<View> straddleView(const Surroundings& around, const world::Portal& portal,
                                 RandomGenerator& random) {
    const Vec3 point = pointInOpening(around.world, portal, random);
    const double off = random.betweenLog(kLeastOff, kMostOff) * (random.below(2) == 0 ? 1.0 : -1.0);
    const Vec3 eye = point + portal.plane.n * off;
    // The side that the eye is on. Up to the tolerance, the eye may also be said to be on the other side, unless the
    // opening is walled from there: then the eye would be behind a wall.
    world::SpaceIndex root = off > 0.0 ? portal.space : portal.destination;
    const Vec3 middle = middleOf(around.world, portal);
    const Vec3 start = point + (middle - point) * 0.2 + portal.plane.n * (off > 0.0 ? kStartOff : -kStartOff);
    RandomGenerator probes = random;
    if (!isFreeViewpoint(around, root, start, probes) || walk(around, root, start, eye) != root)
        return std::nullopt; // at an acute edge `start` is behind a wall, and so is the eye
    const world::PortalIndex back = portal.reciprocal;
    const bool isWalled =
        off > 0.0 ? back == world::kNone || around.world.portals[back].walled : portal.walled;
    if (std::abs(off) < kInPlaneTolerance && !isWalled && random.below(2) == 0)
        root = off > 0.0 ? portal.destination : portal.space;
    const Gaze gaze = gazeAlong(gazeAtPlane(portal.plane.n, random));
    View view;
    view.kind = ViewKind::Straddle;
    view.eye = eye;
    view.yaw = gaze.yaw;
    view.pitch = gaze.pitch;
    view.fov = random.between(40.0, 90.0);
    view.width = around.width;
    view.height = around.height;
    view.root = cellIdOf(around.world, root);
    view.about = fmt::format("opening {} of 0x{:08X}, {} mm off its plane", portal.recordIndex,
                             around.world.spaces[portal.space].cellId, off * 1000.0);
    return centreOf(view) == around.block ? std::optional(view) : std::nullopt;
}

/// The middle of an opening behind an opening of the cell, or of that opening itself.
Vec3 targetThrough(const world::World& world, const world::Portal& first, RandomGenerator& random) {
    const world::Space& behind = world.spaces[first.destination];
    if (first.destination == world::kOutside || behind.portalCount < 2 || random.below(4) == 0)
        return middleOf(world, first);
    const world::Portal& second = world.portals[behind.firstPortal + random.below(behind.portalCount)];
    return second.cornerCount >= 3 ? middleOf(world, second) : middleOf(world, first);
}

} // namespace

void addStraddleViews(const Surroundings& around, std::size_t count, std::vector<View>& out) {
    const std::vector<world::PortalIndex> openings = openingsOf(around.world, around.block);
    for (std::size_t i = 0; i < count && !openings.empty(); ++i) {
        RandomGenerator random(
            around.seed, {static_cast<std::uint64_t>(ViewKind::Straddle), dat::blockWord(around.block), i});
        for (int attempt = 0; attempt < kTriesOfStraddle; ++attempt) {
            const world::Portal& portal = around.world.portals[openings[random.below(openings.size())]];
            if (auto view = straddleView(around, portal, random)) {
                out.push_back(std::move(*view));
                break;
            }
        }
    }
}

void addLensViews(const Surroundings& around, ViewKind kind, std::size_t count, std::vector<View>& out) {
    const bool isWide = kind == ViewKind::Wide;
    std::vector<View> views;
    addRandomViews(around, kind, count, views);
    for (std::size_t i = 0; i < views.size(); ++i) {
        View& view = views[i];
        RandomGenerator random(
            around.seed, {0x4C656E73u, static_cast<std::uint64_t>(kind), dat::blockWord(around.block), i});
        view.fov = isWide ? random.between(150.0, 170.0) : random.between(2.0, 10.0);
        const world::Space& cell = around.world.spaces[world::findCell(around.world, view.root)];
        if (!isWide && cell.portalCount > 0) {
            const world::Portal& first =
                around.world.portals[cell.firstPortal + random.below(cell.portalCount)];
            if (first.cornerCount >= 3 && first.destination != world::kNone) {
                const Gaze gaze = gazeAlong(targetThrough(around.world, first, random) - view.eye);
                view.yaw = gaze.yaw;
                view.pitch = gaze.pitch;
            }
        }
        out.push_back(view);
    }
}

} // namespace limen::check
