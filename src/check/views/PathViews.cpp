#include "check/views/Viewpoints.h"

#include "motion/Locate.h"
#include "world/Loader.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::check {

namespace {

constexpr double kStep = 0.01;            // metres between the views of a walk
constexpr std::size_t kLongestWalk = 150; // views
constexpr double kFovOfWalks = 75.0;      // degrees

/// A point of the tour: its leg, and the share of the leg before it.
struct TourPoint {
    std::size_t leg = 0; ///< from way point `leg` to the next
    double share = 0.0;  ///< 0..1
    Vec3 eye{0.0};
};

/// `count` points evenly along the tour, by length. Requires two way points.
std::vector<TourPoint> pointsAlong(std::span<const world::Place> tour, std::size_t count) {
    std::vector<double> until{0.0}; // length up to each way point
    for (std::size_t i = 1; i < tour.size(); ++i)
        until.push_back(until.back() + (world::isJump(tour[i - 1], tour[i])
                                            ? 0.0
                                            : glm::length(tour[i].eye - tour[i - 1].eye)));
    std::vector<TourPoint> points(count);
    std::size_t leg = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double at = until.back() * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        while (leg + 2 < tour.size() && until[leg + 1] < at)
            ++leg;
        const double length = until[leg + 1] - until[leg];
        const double share = length > 0.0 ? std::clamp((at - until[leg]) / length, 0.0, 1.0) : 0.0;
        points[k] = {leg, share, tour[leg].eye + (tour[leg + 1].eye - tour[leg].eye) * share};
    }
    return points;
}

/// The angle at a share of the shorter way from a to b; degrees.
double turned(double a, double b, double share) {
    return a + std::remainder(b - a, 360.0) * share;
}

/// One walk through openings.
class Walker {
public:
    Walker(const Surroundings& around, std::uint64_t number)
        : around_(around), random_(around.seed, {static_cast<std::uint64_t>(ViewKind::Path),
                                                 dat::blockWord(around.block), number}),
          sway_(random_.between(0.0, 6.28)) {}

    /// Walks up to `most` steps, through `first` and further openings; appends a view for each step.
    void go(world::PortalIndex first, std::size_t most, std::vector<View>& out) {
        if (!startBefore(around_.world.portals[first], 0.5 * kStep * static_cast<double>(most)))
            return;
        world::PortalIndex through = first;
        const std::size_t end = out.size() + most;
        while (out.size() < end) {
            const world::Portal& portal = around_.world.portals[through];
            const Vec3 opening = pointIn(portal);
            if (!stepTo(opening, end, out) ||
                !stepTo(opening - portal.plane.n * random_.between(0.2, 0.6), end, out) ||
                !chooseNext(portal.reciprocal, through))
                return;
        }
    }

private:
    /// Starts up to a metre before an opening. False if there is no free place.
    bool startBefore(const world::Portal& portal, double farthest) {
        const Vec3 opening = pointIn(portal) + portal.plane.n * 0.005;
        for (int i = 0; i < 16; ++i) {
            const Vec3 aside = random_.direction() * 0.4;
            const Vec3 away = glm::normalize(portal.plane.n + aside);
            const Vec3 start = opening + away * std::min(farthest, random_.between(0.3, 1.0));
            if (const auto space = walk(around_, portal.space, opening, start)) {
                at_ = start;
                space_ = *space;
                return true;
            }
        }
        return false;
    }

    /// A random point of an opening, off its edges.
    Vec3 pointIn(const world::Portal& portal) {
        const Vec3 middle = middleOf(around_.world, portal);
        const std::span<const Vec3> corners = cornersOf(around_.world, portal);
        return middle + (corners[random_.below(corners.size())] - middle) * random_.between(0.0, 0.7);
    }

    /// Walks to a point. False at an obstacle, at the end of the block, or with enough views.
    bool stepTo(const Vec3& goal, std::size_t end, std::vector<View>& out) {
        const Vec3 way = goal - at_;
        const double length = glm::length(way);
        const auto steps = static_cast<std::size_t>(std::ceil(length / kStep));
        const Vec3 start = at_;
        for (std::size_t i = 1; i <= steps && out.size() < end; ++i) {
            const Vec3 next = start + way * (static_cast<double>(i) / static_cast<double>(steps));
            const auto space = walk(around_, space_, at_, next);
            if (!space)
                return false;
            at_ = next;
            space_ = *space;
            View view = look(way);
            if (centreOf(view) != around_.block)
                return false;
            out.push_back(std::move(view));
        }
        return true;
    }

    View look(const Vec3& way) {
        sway_ += 0.05;
        const Gaze ahead = gazeAlong(way);
        View view;
        view.kind = ViewKind::Path;
        view.eye = at_;
        view.yaw = ahead.yaw + 50.0 * std::sin(sway_);
        view.pitch = std::clamp(ahead.pitch + 20.0 * std::sin(sway_ * 0.7), -89.0, 89.0);
        view.fov = kFovOfWalks;
        view.width = around_.width;
        view.height = around_.height;
        view.root = cellIdOf(around_.world, space_);
        view.about = "walk";
        return view;
    }

    /// Chooses another opening of the current space than `back`. False if there is none.
    bool chooseNext(world::PortalIndex back, world::PortalIndex& through) {
        const world::Space& space = around_.world.spaces[space_];
        if (space_ == world::kOutside || space.portalCount == 0)
            return false;
        const std::size_t first = random_.below(space.portalCount);
        for (std::size_t i = 0; i < space.portalCount; ++i) {
            const auto p =
                static_cast<world::PortalIndex>(space.firstPortal + (first + i) % space.portalCount);
            const world::Portal& portal = around_.world.portals[p];
            if (p != back && portal.destination != world::kNone && portal.plane.signedDistance(at_) > 0.0) {
                through = p;
                return true;
            }
        }
        return false;
    }

    const Surroundings& around_;
    RandomGenerator random_;
    double sway_;
    Vec3 at_{0.0};
    world::SpaceIndex space_ = world::kOutside;
};

/// The space of a way point without a cell: tours stay in buildings and outdoors. kNone if several cells
/// contain it.
world::SpaceIndex locateOnTour(const world::World& world, const Vec3& eye) {
    const motion::Located located = motion::locate(world, eye);
    return located.ambiguous ? world::kNone : located.space;
}

} // namespace

std::size_t tourPointsIn(std::span<const world::Place> tour, std::size_t count, dat::BlockCoord block) {
    if (tour.size() < 2)
        return 0;
    const std::vector<TourPoint> points = pointsAlong(tour, count);
    return static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [&](const TourPoint& p) { return world::blockAt(p.eye) == block; }));
}

void addTourViews(const Surroundings& around, std::size_t count, std::vector<View>& out) {
    if (around.tour.size() < 2)
        return;
    for (const TourPoint& point : pointsAlong(around.tour, count)) {
        if (world::blockAt(point.eye) != around.block)
            continue;
        const world::Place &from = around.tour[point.leg], &to = around.tour[point.leg + 1];
        const world::SpaceIndex start =
            from.cell == 0 ? locateOnTour(around.world, from.eye) : world::findCell(around.world, from.cell);
        if (start == world::kNone)
            continue;
        const auto root = walk(around, start, from.eye, point.eye);
        if (!root)
            continue;
        View view;
        view.kind = ViewKind::Path;
        view.eye = point.eye;
        view.yaw = turned(from.yaw, to.yaw, point.share);
        view.pitch = turned(from.pitch, to.pitch, point.share);
        view.fov = kFovOfWalks;
        view.width = around.width;
        view.height = around.height;
        view.root = cellIdOf(around.world, *root);
        view.about = fmt::format("tour, after way point {}", point.leg);
        if (centreOf(view) == around.block)
            out.push_back(std::move(view));
    }
}

void addWalkViews(const Surroundings& around, std::size_t count, std::vector<View>& out) {
    const std::vector<world::PortalIndex> openings = openingsOf(around.world, around.block);
    if (openings.empty())
        return;
    const std::size_t end = out.size() + count;
    // Walks that end early are replaced by others. The bound ends the search in a block where every walk
    // fails.
    for (std::uint64_t number = 0; out.size() < end && number < 4 * (count / kLongestWalk + 1) + 16;
         ++number) {
        RandomGenerator random(
            around.seed, {static_cast<std::uint64_t>(ViewKind::Path), dat::blockWord(around.block), ~number});
        Walker(around, number)
            .go(openings[random.below(openings.size())], std::min(kLongestWalk, end - out.size()), out);
    }
}

} // namespace limen::check
