#include "frame/WorldGraph.h"

namespace limen::frame {

Result<visibility::Graph> visibilityGraph(const world::World& world) {
    static_assert(world::kNone == visibility::kNone);
    std::vector<visibility::SpaceDesc> spaces;
    spaces.reserve(world.spaces.size());
    for (const world::Space& s : world.spaces) {
        spaces.push_back({s.firstPortal, s.portalCount, s.zone});
    }
    std::vector<visibility::PortalDesc> portals;
    portals.reserve(world.portals.size());
    for (const world::Portal& p : world.portals) {
        portals.push_back({p.space, p.destination, p.reciprocal, p.firstCorner, p.cornerCount, p.exact});
    }
    return visibility::Graph::build(spaces, portals, world.portalCorners);
}

} // namespace limen::frame
