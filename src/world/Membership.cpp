#include "world/Membership.h"

#include "core/Assert.h"
#include "world/PolygonDistance.h"

#include <algorithm>

namespace limen::world {

Membership::Membership(const World& world) : world_(world) {
    bounds_.reserve(world.portals.size());
    for (const Portal& portal : world.portals)
        bounds_.push_back(portal.walled ? Sphere{} : boundingSphere(cornersOf(world, portal)));
}

bool Membership::reaches(PortalIndex portal, const Sphere& sphere) const {
    const Vec3 offset = bounds_[portal].centre - sphere.centre;
    const double reach = bounds_[portal].radius + sphere.radius;
    if (bounds_[portal].radius < 0.0 || glm::dot(offset, offset) > reach * reach)
        return false;
    const Portal& p = world_.portals[portal];
    return distanceToPolygon(cornersOf(world_, p), p.plane, sphere.centre) <= sphere.radius;
}

void Membership::reach(SpaceIndex start, const Sphere& sphere, std::span<const std::uint8_t> closed,
                       std::vector<SpaceIndex>& out) const {
    LIMEN_ASSERT(start < world_.spaces.size(), "the sphere is in a space");
    out.assign(1, start);
    extend(sphere, closed, out);
}

void Membership::extend(const Sphere& sphere, std::span<const std::uint8_t> closed,
                        std::vector<SpaceIndex>& out) const {
    LIMEN_ASSERT(closed.empty() || closed.size() == bounds_.size(), "a state for each portal");
    if (sphere.radius < 0.0)
        return;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Space& space = world_.spaces[out[i]];
        for (PortalIndex p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const SpaceIndex next = world_.portals[p].destination;
            if (next == kNone || (!closed.empty() && closed[p] != 0) || !reaches(p, sphere))
                continue;
            if (std::find(out.begin(), out.end(), next) == out.end())
                out.push_back(next);
        }
    }
}

} // namespace limen::world
