#include "frame/WorldGraph.h"

namespace limen::frame {

Result<visibility::Graph> visibilityGraph(const world::World& world, GraphZones zones) {
    static_assert(world::kNone == visibility::kNone);
    std::vector<visibility::SpaceDesc> spaces;
    spaces.reserve(world.spaces.size());
    for (const world::Space& s : world.spaces) {
        const auto number = static_cast<std::uint32_t>(spaces.size());
        spaces.push_back({s.firstPortal, s.portalCount, zones == GraphZones::OfWorld ? s.zone : number});
    }
    std::vector<visibility::PortalDesc> portals;
    std::vector<Vec3> vertices = world.portalCorners; // outlines are appended
    portals.reserve(world.portals.size());
    for (const world::Portal& p : world.portals) {
        visibility::PortalDesc& desc = portals.emplace_back();
        desc = {p.space, p.destination, p.reciprocal, p.firstCorner, p.cornerCount, p.exact};
        if (p.walled)
            desc.vertexCount = 0; // without an area it is never admitted
        else if (p.vertexCount > p.cornerCount) {
            desc.firstOutline = static_cast<std::uint32_t>(vertices.size());
            desc.outlineCount = p.vertexCount;
            const auto outline = polygonOf(world, p);
            vertices.insert(vertices.end(), outline.begin(), outline.end());
        }
    }
    return visibility::Graph::build(spaces, portals, vertices);
}

} // namespace limen::frame
