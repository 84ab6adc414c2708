#include "check/views/Viewpoints.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::check {

namespace {

constexpr double kFovOfSweeps = 75.0; // degrees
/// Metres from an edge or a corner.
constexpr double kBesideLeast = 0.004, kBesideMost = 0.06;
/// Metres from the opening's plane: a point there is in the space on that side, unless a wall leans over it.
constexpr double kAnchor = 0.005;
constexpr int kTriesOfSweep = 24; // combinations tried for one view

enum class Line : std::uint8_t { Square, Aslant, BesideEdge, BesideCorner, OnEdge, OnCorner };
constexpr std::array<const char*, 6> kLineNames{"square",          "aslant",     "beside an edge",
                                                "beside a corner", "on an edge", "on a corner"};
enum class Look : std::uint8_t { Along, Against, Sideways, GrazingOut, GrazingIn, Aslant, Anyhow };
constexpr std::size_t kLooks = 7;

/// Distances of viewpoints from an opening's plane, positive before it; metres.
std::vector<double> distances() {
    std::vector<double> all;
    for (int cm = -30; cm <= 30; ++cm)
        if (std::abs(cm) > 2)
            all.push_back(cm / 100.0);
    for (int mm = -20; mm <= 20; ++mm)
        all.push_back(mm / 1000.0);
    for (const double tiny : {0.0001, 0.00015, 0.00019, 0.00021, 0.00025, 0.0005}) {
        all.push_back(tiny);
        all.push_back(-tiny);
    }
    return all;
}

/// One combination of portal, side, line, distance and gaze.
struct Combination {
    world::PortalIndex portal = 0;
    bool fromBehind = false; ///< the line begins in the space that the portal leads to
    Line line = Line::Square;
    double distance = 0.0;
    Look look = Look::Along;
};

Combination combinationAt(std::span<const world::PortalIndex> openings, std::span<const double> all,
                          std::size_t index) {
    Combination c;
    const auto take = [&index](std::size_t radix) {
        const std::size_t digit = index % radix;
        index /= radix;
        return digit;
    };
    c.look = static_cast<Look>(take(kLooks));
    c.distance = all[take(all.size())];
    c.fromBehind = take(2) != 0;
    c.line = static_cast<Line>(take(kLineNames.size()));
    c.portal = openings[take(openings.size())];
    return c;
}

/// A line through an opening.
struct Course {
    Vec3 foot{0.0};  ///< where the line meets the opening's plane
    Vec3 inner{0.0}; ///< a point of the opening near the foot, clear of its edges
    Vec3 way{0.0};   ///< towards the portal's space, 1 m along the normal
};

Vec3 anyTangent(const Vec3& n, RandomGenerator& random) {
    for (;;) {
        const Vec3 across = glm::cross(n, random.direction());
        if (glm::length(across) > 0.1)
            return glm::normalize(across);
    }
}

/// Moves a point towards another, at most half of the way.
Vec3 towards(const Vec3& from, const Vec3& to, double metres) {
    const double length = glm::length(to - from);
    return length > 0.0 ? from + (to - from) * std::min(0.5, metres / length) : from;
}

Course courseOf(const world::World& world, const world::Portal& portal, Line line, RandomGenerator& random) {
    const Vec3 middle = middleOf(world, portal);
    const std::span<const Vec3> corners = cornersOf(world, portal);
    const std::size_t i = random.below(corners.size());
    const Vec3& corner = corners[i];
    const Vec3 edge = corner + (corners[(i + 1) % corners.size()] - corner) * random.between(0.2, 0.8);
    const double beside = random.betweenLog(kBesideLeast, kBesideMost);
    Course course{middle, middle, portal.plane.n};
    switch (line) {
    case Line::Square:
        break;
    case Line::Aslant:
        course.way += anyTangent(portal.plane.n, random) * random.between(0.5, 2.0);
        break;
    case Line::BesideEdge:
        course.foot = course.inner = towards(edge, middle, beside);
        break;
    case Line::BesideCorner:
        course.foot = course.inner = towards(corner, middle, beside);
        break;
    case Line::OnEdge:
        course.foot = edge;
        course.inner = towards(edge, middle, beside);
        break;
    case Line::OnCorner:
        course.foot = corner;
        course.inner = towards(corner, middle, beside);
        break;
    }
    return course;
}

Vec3 directionOf(Look look, const Vec3& n, RandomGenerator& random) {
    const Vec3 aside = anyTangent(n, random);
    const double grazing = std::tan(random.betweenLog(0.05, 3.0) * (std::numbers::pi / 180.0));
    switch (look) {
    case Look::Along:
        return -n;
    case Look::Against:
        return n;
    case Look::Sideways:
        return aside;
    case Look::GrazingOut:
        return aside - n * grazing;
    case Look::GrazingIn:
        return aside + n * grazing;
    case Look::Aslant:
        return aside - n;
    case Look::Anyhow:
        break;
    }
    return random.direction();
}

/// The space of an eye that moves along the course; none if a wall is in the way. A point of the opening
/// itself is in both spaces, but a point before it may be in neither: walls may meet the opening at a sharp
/// angle.
std::optional<world::SpaceIndex> spaceAt(const Surroundings& around, const Combination& c,
                                         const Course& course, const Vec3& eye) {
    const world::Portal& portal = around.world.portals[c.portal];
    const world::SpaceIndex start = c.fromBehind ? portal.destination : portal.space;
    const Vec3 anchor = course.inner + course.way * (c.fromBehind ? -kAnchor : kAnchor);
    if (walk(around, start, course.inner, anchor) != start)
        return std::nullopt;
    return walk(around, start, anchor, eye);
}

std::optional<View> viewOf(const Surroundings& around, const Combination& c, RandomGenerator& random) {
    const world::Portal& portal = around.world.portals[c.portal];
    const Course course = courseOf(around.world, portal, c.line, random);
    const Vec3 eye = course.foot + course.way * c.distance;
    const auto root = spaceAt(around, c, course, eye);
    if (!root)
        return std::nullopt;
    const Gaze gaze = gazeAlong(directionOf(c.look, portal.plane.n, random));
    View view;
    view.kind = ViewKind::Sweep;
    view.eye = eye;
    view.yaw = gaze.yaw;
    view.pitch = gaze.pitch;
    view.fov = kFovOfSweeps;
    view.width = around.width;
    view.height = around.height;
    view.root = cellIdOf(around.world, *root);
    view.about =
        fmt::format("opening {} of 0x{:08X}, {}, {} mm, from {}", portal.recordIndex,
                    around.world.spaces[portal.space].cellId, kLineNames[static_cast<std::size_t>(c.line)],
                    c.distance * 1000.0, c.fromBehind ? "behind" : "before");
    return centreOf(view) == around.block ? std::optional(view) : std::nullopt;
}

} // namespace

void addSweepViews(const Surroundings& around, std::size_t count, std::vector<View>& out) {
    const std::vector<world::PortalIndex> openings = openingsOf(around.world, around.block);
    if (openings.empty())
        return;
    const std::vector<double> all = distances();
    const std::size_t combinations = openings.size() * kLineNames.size() * 2 * all.size() * kLooks;
    for (std::size_t i = 0; i < count; ++i) {
        RandomGenerator random(
            around.seed, {static_cast<std::uint64_t>(ViewKind::Sweep), dat::blockWord(around.block), i});
        // One of each of `count` equal runs. A combination without a legal viewpoint is replaced by a random
        // one.
        double place = (static_cast<double>(i) + random.unit()) / static_cast<double>(count);
        for (int attempt = 0; attempt < kTriesOfSweep; ++attempt, place = random.unit()) {
            const auto index = std::min(combinations - 1,
                                        static_cast<std::size_t>(place * static_cast<double>(combinations)));
            if (auto view = viewOf(around, combinationAt(openings, all, index), random)) {
                out.push_back(std::move(*view));
                break;
            }
        }
    }
}

} // namespace limen::check
