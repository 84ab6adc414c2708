#include "world/assemble/Lights.h"

#include "core/Assert.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace limen::world {
namespace {

constexpr std::size_t kMostLampsOfAThing = 8;
constexpr double kWallReach = 1.3; ///< of a lamp's falloff
/// Metres: radius of the moving objects that a cell's lamps are chosen for (shaders/include/incident.glsl).
constexpr double kMovingRadius = 1.0;

double distanceToBox(const Aabb& box, const Vec3& p) {
    return box.empty() ? 0.0 : glm::length(p - glm::clamp(p, box.min, box.max));
}

/// By space: a number that connected cells share. Portals to the outside connect nothing.
std::vector<SpaceIndex> connectedCells(const World& world) {
    std::vector<SpaceIndex> parent(world.spaces.size());
    std::iota(parent.begin(), parent.end(), SpaceIndex{0});
    const auto rootOf = [&](SpaceIndex space) {
        while (parent[space] != space)
            space = parent[space] = parent[parent[space]];
        return space;
    };
    for (const Portal& portal : world.portals) {
        if (portal.space == kOutside || portal.destination == kOutside || portal.destination == kNone)
            continue;
        const SpaceIndex a = rootOf(portal.space), b = rootOf(portal.destination);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (SpaceIndex i = 0; i < parent.size(); ++i)
        parent[i] = rootOf(i);
    return parent;
}

class Lighting {
public:
    explicit Lighting(World& world)
        : world_(world), connected_(connectedCells(world)), lampsOf_(world.spaces.size()) {}

    void add(const PlacedLamp& lamp) {
        LIMEN_ASSERT(lamp.placedIn < world_.spaces.size(), "a lamp is in a space");
        const Vec3f power = lamp.light.colour * lamp.light.intensity;
        if (lamp.placedIn == kOutside || power.x + power.y + power.z <= 0.0f)
            return;
        lampsOf_[connected_[lamp.placedIn]].push_back(static_cast<std::uint32_t>(world_.lights.size()));
        world_.lights.push_back(lamp.light);
    }

    void lightSpace(SpaceIndex index) {
        Space& space = world_.spaces[index];
        if (index == kOutside) {
            space.lightSet = setOf({LightSet::Kind::Outdoors, false}, {});
            return;
        }
        const auto reaches = [&](double share, double beyond) {
            return [&space, share, beyond](const Light& lamp) {
                return distanceToBox(space.bounds, lamp.position) <= share * double{lamp.falloff} + beyond;
            };
        };
        const bool sealed = !space.seenOutside;
        space.lightSet =
            setOf({LightSet::Kind::Moving, sealed}, lampsAround(index, reaches(1.0, kMovingRadius)));
        if (space.shell != kNone)
            world_.instanceLightSets[space.shell] =
                setOf({LightSet::Kind::Walls, sealed}, lampsAround(index, reaches(kWallReach, 0.0)));
    }

    void lightThing(const ObjectGroup& object) {
        const SpaceIndex space = world_.instances[object.firstInstance].placedIn;
        if (space == kOutside)
            return;
        const auto distance = [&](const Light& lamp) {
            return glm::length(lamp.position - object.bounds.centre);
        };
        std::vector<std::uint32_t> lamps = lampsAround(space, [&](const Light& lamp) {
            return distance(lamp) <= double{lamp.falloff} + object.bounds.radius;
        });
        std::stable_sort(lamps.begin(), lamps.end(), [&](std::uint32_t a, std::uint32_t b) {
            return distance(world_.lights[a]) < distance(world_.lights[b]);
        });
        lamps.resize(std::min(lamps.size(), kMostLampsOfAThing));
        const std::uint32_t set = setOf({LightSet::Kind::Thing, !world_.spaces[space].seenOutside}, lamps);
        for (InstanceIndex i = 0; i < object.instanceCount; ++i)
            world_.instanceLightSets[object.firstInstance + i] = set;
    }

private:
    using Use = std::pair<LightSet::Kind, bool>; ///< and whether it is sealed

    template <class Counts>
    [[nodiscard]] std::vector<std::uint32_t> lampsAround(SpaceIndex space, const Counts& counts) const {
        std::vector<std::uint32_t> lamps;
        for (const std::uint32_t lamp : lampsOf_[connected_[space]])
            if (counts(world_.lights[lamp]))
                lamps.push_back(lamp);
        return lamps;
    }

    /// Equal sets are stored once.
    std::uint32_t setOf(const Use& use, const std::vector<std::uint32_t>& lamps) {
        const auto [entry, fresh] =
            sets_.try_emplace({use, lamps}, static_cast<std::uint32_t>(world_.lightSets.size()));
        if (fresh) {
            world_.lightSets.push_back({use.first, use.second,
                                        static_cast<std::uint32_t>(world_.lampRefs.size()),
                                        static_cast<std::uint32_t>(lamps.size())});
            world_.lampRefs.insert(world_.lampRefs.end(), lamps.begin(), lamps.end());
        }
        return entry->second;
    }

    World& world_;
    const std::vector<SpaceIndex> connected_;
    std::vector<std::vector<std::uint32_t>> lampsOf_; ///< by the number of connected cells
    std::map<std::pair<Use, std::vector<std::uint32_t>>, std::uint32_t> sets_;
};

} // namespace

void lightWorld(std::span<const PlacedLamp> lamps, std::span<const ObjectGroup> objects, World& world) {
    LIMEN_ASSERT(world.lights.empty() && world.lightSets.empty(), "spaces are lit once");
    world.instanceLightSets.assign(world.instances.size(), kNone);
    Lighting lighting(world);
    for (const PlacedLamp& lamp : lamps)
        lighting.add(lamp);
    for (SpaceIndex i = 0; i < world.spaces.size(); ++i)
        lighting.lightSpace(i);
    for (const ObjectGroup& object : objects)
        lighting.lightThing(object);
}

} // namespace limen::world
