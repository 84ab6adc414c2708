#include "world/load/LoadCache.h"

namespace limen::world {

std::size_t bytesOf(const BlockContent& block) {
    std::size_t bytes = sizeof(block) + bytesOf(block.heightIndices) + bytesOf(block.terrain) +
                        bytesOf(block.cells) + bytesOf(block.portals) + bytesOf(block.zones) +
                        bytesOf(block.exteriors) + bytesOf(block.objects) + bytesOf(block.findings) +
                        bytesOf(block.recordFindings);
    for (const CellContent& cell : block.cells)
        bytes += bytesOf(cell.shell) + bytesOf(cell.surfaces) + bytesOf(cell.bsp) +
                 bytesOf(cell.shape.points) + bytesOf(cell.shape.normals) + bytesOf(cell.shape.edges);
    for (const PortalContent& portal : block.portals)
        bytes += bytesOf(portal.points) + bytesOf(portal.corners);
    for (const std::vector<std::uint32_t>& zone : block.zones)
        bytes += bytesOf(zone);
    for (const ExteriorContent& exterior : block.exteriors)
        bytes += bytesOf(exterior.mesh) + bytesOf(exterior.surfaces);
    return bytes;
}

} // namespace limen::world
