#include "world/mesh/ModelCache.h"

namespace limen::world {

std::size_t bytesOf(const MeshData& mesh) {
    std::size_t bytes = bytesOf(mesh.vertices) + bytesOf(mesh.polygonIds) + bytesOf(mesh.inOpenings);
    for (const std::vector<std::uint32_t>& indices : mesh.indices)
        bytes += bytesOf(indices);
    return bytes;
}

std::size_t bytesOf(const Model& model) {
    return sizeof(model) + bytesOf(model.parts) + bytesOf(model.farther) + bytesOf(model.lights);
}

std::size_t bytesOf(const std::optional<PartMesh>& part) {
    return sizeof(part) + (part ? bytesOf(part->mesh) + bytesOf(part->surfaces) + part->clamp.size() : 0);
}

} // namespace limen::world
