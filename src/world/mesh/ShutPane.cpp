#include "world/mesh/ShutPane.h"

#include <algorithm>

namespace limen::world {

namespace {

Vec3 onto(std::span<const Vec3> outline, const Vec3& corner) {
    const auto nearest = std::min_element(outline.begin(), outline.end(), [&](const Vec3& a, const Vec3& b) {
        return glm::distance(a, corner) < glm::distance(b, corner);
    });
    return nearest != outline.end() && glm::distance(*nearest, corner) <= kWeldTolerance ? *nearest : corner;
}

} // namespace

MeshData placedBetween(std::span<const Vec3> outline, const MeshData& part, const Placement& placement) {
    MeshData placed = part;
    for (MeshVertex& vertex : placed.vertices) {
        vertex.placeAt(onto(outline, placement.origin + placement.linear * vertex.corner()));
        const Vec3 normal = normalMatrix(placement.linear) * Vec3(vertex.normal);
        const double length = glm::length(normal);
        vertex.normal = length > 0.0 ? Vec3f(normal / length) : Vec3f(0.0f);
        vertex.neighbour = Vec3f(0.0f);
    }
    return placed;
}

} // namespace limen::world
