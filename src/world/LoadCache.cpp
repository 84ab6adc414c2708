#include "world/LoadCache.h"

namespace limen::world {
namespace {

template <class T>
std::size_t bytesIn(const std::vector<T>& list) {
    return list.capacity() * sizeof(T);
}

std::size_t bytesIn(const MeshData& mesh) {
    std::size_t bytes = bytesIn(mesh.vertices) + bytesIn(mesh.polygonIds);
    for (const std::vector<std::uint32_t>& indices : mesh.indices)
        bytes += bytesIn(indices);
    return bytes;
}

std::size_t bytesIn(const CellShape& shape) {
    return bytesIn(shape.points) + bytesIn(shape.normals) + bytesIn(shape.edges);
}

} // namespace

std::size_t bytesOf(const BlockContent& block) {
    std::size_t bytes = sizeof(block) + bytesIn(block.heightIndices) + bytesIn(block.terrain) +
                        bytesIn(block.cells) + bytesIn(block.portals) + bytesIn(block.zones) +
                        bytesIn(block.exteriors) + bytesIn(block.objects) + bytesIn(block.findings) +
                        bytesIn(block.said);
    for (const CellContent& cell : block.cells)
        bytes += bytesIn(cell.shell) + bytesIn(cell.surfaces) + bytesIn(cell.bsp) + bytesIn(cell.shape);
    for (const PortalContent& portal : block.portals)
        bytes += bytesIn(portal.points) + bytesIn(portal.corners);
    for (const std::vector<std::uint32_t>& zone : block.zones)
        bytes += bytesIn(zone);
    for (const ExteriorContent& exterior : block.exteriors)
        bytes += bytesIn(exterior.mesh) + bytesIn(exterior.surfaces);
    return bytes;
}

std::size_t bytesOf(const Model& model) {
    return sizeof(model) + bytesIn(model.parts) + bytesIn(model.farther) + bytesIn(model.lights);
}

std::size_t bytesOf(const std::optional<PartMesh>& part) {
    return sizeof(part) + (part ? bytesIn(part->mesh) + bytesIn(part->surfaces) + part->clamp.size() : 0);
}

} // namespace limen::world
