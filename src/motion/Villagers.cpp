#include "motion/Villagers.h"

#include "core/Assert.h"
#include "motion/Locate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::motion {
namespace {

double compassOf(const Vec3& direction) {
    return std::atan2(direction.x, direction.y) * 180.0 / std::numbers::pi;
}

} // namespace

VillagerPlace placeOf(const world::World& world, const world::Villager& villager, double seconds) {
    LIMEN_ASSERT(villager.route < world.routes.size(), "a villager has a route of the world");
    const world::Route& route = world.routes[villager.route];
    LIMEN_ASSERT(route.pointCount >= 2, "a route has at least two points");
    const auto points = std::span(world.routePoints).subspan(route.firstPoint, route.pointCount);
    double along = std::fmod(villager.start + villager.speed * seconds, route.length);
    along += along < 0.0 ? route.length : 0.0;
    const std::size_t count = points.size();
    // There and back again is a loop of the points and, in reverse, all but the two ends.
    const std::size_t legs = route.loop ? count : 2 * count - 2;
    const auto point = [&](std::size_t i) { return i < count ? points[i] : points[2 * count - 2 - i]; };
    for (std::size_t leg = 0;; ++leg) {
        const world::RoutePoint from = point(leg);
        const Vec3 way = point((leg + 1) % legs).position - from.position;
        const double length = glm::length(way);
        if (along <= length || leg + 1 == legs) {
            const Vec3 at = from.position + way * (length > 0.0 ? std::min(along / length, 1.0) : 0.0);
            return {at, compassOf(way), sweep(world, from.space, from.position, at)};
        }
        along -= length;
    }
}

CyclePoint cyclePointOf(const world::World& world, const world::Villager& villager, double seconds) {
    return cyclePoint(world, villager.body, gaitAt(world, villager.body, villager.speed),
                      villager.start + villager.speed * seconds, seconds);
}

} // namespace limen::motion
