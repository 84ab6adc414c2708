#include "world/assemble/VillagerAssembler.h"

#include "world/Lookup.h"
#include "world/assemble/BodyAssembler.h"

#include <algorithm>

namespace limen::world {

void VillagerAssembler::add(const VillagerEntry& entry, std::size_t index,
                            std::span<const RouteEntry> routes) {
    const auto route = std::find_if(routes.begin(), routes.end(),
                                    [&](const RouteEntry& r) { return r.name == entry.route; });
    if (route == routes.end()) {
        world_.findings.push_back(
            {0, "world.json: villager \"" + entry.name + "\" walks a route that is not there"});
        return;
    }
    Villager villager;
    villager.name = entry.name;
    villager.speed = entry.speed;
    villager.start = entry.start;
    villager.route = addRoute(*route);
    if (villager.route == kNone)
        return;
    villager.body =
        bodies_.add(entry.model, InstanceKind::Dynamic, dynamicObject(DynamicObject::Villager, index),
                    {.dress = dressOf(entry.model, {entry.clothing, entry.basePalette}, records_)});
    world_.villagers.push_back(std::move(villager));
    particles_.addToVillager(static_cast<std::uint32_t>(world_.villagers.size() - 1), entry.model,
                             entry.play);
}

std::uint32_t VillagerAssembler::addRoute(const RouteEntry& entry) {
    LIMEN_ASSERT(entry.points.size() >= 2, "readMovingEntries refuses shorter routes");
    Route route;
    route.firstPoint = static_cast<std::uint32_t>(world_.routePoints.size());
    route.pointCount = static_cast<std::uint32_t>(entry.points.size());
    route.loop = entry.loop;
    std::vector<RoutePoint> points;
    for (const RouteEntry::Point& point : entry.points) {
        const SpaceIndex space = point.cell == 0 ? kOutside : findCell(world_, point.cell);
        if (space == kNone || (space == kOutside && findBlock(world_, blockAt(point.position)) == nullptr))
            return kNone;
        if (!points.empty())
            route.length += glm::length(point.position - points.back().position) * (entry.loop ? 1.0 : 2.0);
        points.push_back({point.position, space});
    }
    if (entry.loop)
        route.length += glm::length(points.front().position - points.back().position);
    if (!(route.length > 0.0))
        return kNone;
    world_.routePoints.insert(world_.routePoints.end(), points.begin(), points.end());
    world_.routes.push_back(route);
    return static_cast<std::uint32_t>(world_.routes.size() - 1);
}

} // namespace limen::world
