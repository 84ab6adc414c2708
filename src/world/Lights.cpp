#include "world/Lights.h"

#include <algorithm>

namespace limen::world {
namespace {

constexpr std::size_t kMostLamps = 8;
constexpr float kDungeonAmbient = 0.22f; ///< sky_weather.md: "0.2-ish grey"
constexpr float kRoomAmbient = 0.10f, kRoomSky = 0.55f, kRoomSun = 0.15f;

struct Candidate {
    Light light;
    double strength = 0.0;
};

double distanceToBox(const Aabb& box, const Vec3& p) {
    return box.empty() ? 0.0 : glm::length(p - glm::clamp(p, box.min, box.max));
}

LightSet baseLight(const Space& space, bool outside) {
    LightSet set;
    if (outside)
        return set;
    set.ambient = Vec3f(space.seenOutside ? kRoomAmbient : kDungeonAmbient);
    set.sky = space.seenOutside ? kRoomSky : 0.0f;
    set.sun = space.seenOutside ? kRoomSun : 0.0f;
    return set;
}

} // namespace

void lightSpaces(const std::vector<PlacedLamp>& lamps, World& world) {
    std::vector<std::vector<Candidate>> bySpace(world.spaces.size());
    const Membership membership(world);
    std::vector<SpaceIndex> reached;
    for (const PlacedLamp& lamp : lamps) {
        membership.reach(lamp.placedIn, {lamp.light.position, lamp.light.range}, reached);
        const double power = lamp.light.colour.x + lamp.light.colour.y + lamp.light.colour.z;
        for (const SpaceIndex space : reached) {
            const double distance =
                space == kOutside ? 0.0 : distanceToBox(world.spaces[space].bounds, lamp.light.position);
            const bool counts = space != kOutside || lamp.placedIn == kOutside;
            if (counts && distance < lamp.light.range && power > 0.0)
                bySpace[space].push_back({lamp.light, power * (1.0 - distance / lamp.light.range)});
        }
    }
    for (SpaceIndex i = 0; i < world.spaces.size(); ++i) {
        std::vector<Candidate>& found = bySpace[i];
        std::stable_sort(found.begin(), found.end(),
                         [](const auto& a, const auto& b) { return a.strength > b.strength; });
        LightSet set = baseLight(world.spaces[i], i == kOutside);
        set.firstLight = static_cast<std::uint32_t>(world.lights.size());
        set.lightCount = static_cast<std::uint32_t>(std::min(found.size(), kMostLamps));
        for (std::size_t k = 0; k < set.lightCount; ++k)
            world.lights.push_back(found[k].light);
        world.spaces[i].lightSet = static_cast<std::uint32_t>(world.lightSets.size());
        world.lightSets.push_back(set);
    }
}

} // namespace limen::world
