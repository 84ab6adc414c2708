#include "world/assemble/Lights.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "world/Membership.h"
#include "world/PolygonDistance.h"

#include <algorithm>

namespace limen::world {
namespace {

constexpr std::size_t kMostLamps = 8;
constexpr float kDungeonAmbient = 0.22f; ///< docs/formats/light.md#ambient-light-and-sun
constexpr float kRoomAmbient = 0.10f, kRoomSky = 0.55f, kRoomSun = 0.15f;

struct Candidate {
    Light light;
    double strength = 0.0;
};

double distanceToBox(const Aabb& box, const Vec3& p) {
    return box.empty() ? 0.0 : glm::length(p - glm::clamp(p, box.min, box.max));
}

/// The spaces that a lamp's straight rays reach through openings. Lamps cast no shadows: without this test, a
/// lamp in a cellar would light the room above through the floor if stairs connect them. Conservative: a
/// space in doubt counts as reached.
class LampRays {
public:
    LampRays(const World& world, const PlacedLamp& lamp)
        : world_(world), at_(lamp.light.position), range_(lamp.light.range) {
        follow({lamp.placedIn, {}});
        while (!open_.empty() && steps_ < kMostSteps) {
            const Beam beam = std::move(open_.back());
            open_.pop_back();
            follow(beam);
        }
    }
    [[nodiscard]] bool arriveIn(SpaceIndex space) const {
        return !open_.empty() || std::find(met_.begin(), met_.end(), space) != met_.end();
    }

private:
    /// The part of the lamp's light that enters a space through a chain of openings.
    struct Beam {
        SpaceIndex space = kOutside;
        std::vector<Plane> sides; ///< through the lamp, inside positive; none: all directions
    };
    /// Openings tested. With more, the lamp counts as visible from every space.
    static constexpr std::size_t kMostSteps = 1024;
    static constexpr double kSize = 0.1;       ///< radius of a lamp, metres
    static constexpr double kTolerance = 1e-3; ///< of clipping, metres

    void follow(const Beam& beam) {
        if (std::find(met_.begin(), met_.end(), beam.space) == met_.end())
            met_.push_back(beam.space);
        const Space& space = world_.spaces[beam.space];
        for (PortalIndex p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            ++steps_;
            const Portal& portal = world_.portals[p];
            if (portal.destination != kNone &&
                distanceToPolygon(cornersOf(world_, portal), portal.plane, at_) <= range_)
                pass(beam, portal);
        }
    }

    void pass(const Beam& beam, const Portal& portal) {
        const double before = portal.plane.signedDistance(at_);
        if (before <= kSize) {
            // The lamp is in the opening or a little beyond it, and still lights the space on the other side.
            if (beam.sides.empty() && met_.front() == beam.space)
                open_.push_back({portal.destination, {}});
            return;
        }
        std::vector<Vec3> rest(cornersOf(world_, portal).begin(), cornersOf(world_, portal).end());
        std::vector<Vec3> clipped;
        for (const Plane& side : beam.sides) {
            clipPolygon(rest, side, kTolerance, clipped);
            rest.swap(clipped);
        }
        if (rest.size() >= 3)
            open_.push_back({portal.destination, sidesOf(rest)});
    }

    /// The planes through the lamp and the polygon's edges. The polygon is counter-clockwise seen from the
    /// lamp.
    [[nodiscard]] std::vector<Plane> sidesOf(const std::vector<Vec3>& polygon) const {
        std::vector<Plane> sides;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 n = glm::cross(polygon[(i + 1) % polygon.size()] - at_, polygon[i] - at_);
            const double length = glm::length(n);
            if (length > 1e-9)
                sides.push_back({n / length, -glm::dot(n / length, at_)});
        }
        return sides;
    }

    const World& world_;
    Vec3 at_;
    double range_;
    std::size_t steps_ = 0;
    std::vector<Beam> open_;
    std::vector<SpaceIndex> met_;
};

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

void lightSpaces(std::span<const PlacedLamp> lamps, World& world) {
    LIMEN_ASSERT(world.lights.empty() && world.lightSets.empty(), "spaces are lit once");
    std::vector<std::vector<Candidate>> bySpace(world.spaces.size());
    const Membership membership(world);
    std::vector<SpaceIndex> reached;
    for (const PlacedLamp& lamp : lamps) {
        LIMEN_ASSERT(lamp.placedIn < world.spaces.size(), "a lamp is in a space");
        membership.reach(lamp.placedIn, {lamp.light.position, lamp.light.range}, {}, reached);
        const LampRays rays(world, lamp);
        const double power = lamp.light.colour.x + lamp.light.colour.y + lamp.light.colour.z;
        for (const SpaceIndex space : reached) {
            const double distance =
                space == kOutside ? 0.0 : distanceToBox(world.spaces[space].bounds, lamp.light.position);
            const bool counts = (space != kOutside || lamp.placedIn == kOutside) && rays.arriveIn(space);
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
