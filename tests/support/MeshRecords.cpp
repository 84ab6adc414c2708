#include "support/MeshRecords.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>

namespace limen::test {

std::uint16_t MeshRecords::add(std::span<const Vec3> points, std::int16_t surface, bool twoSided) {
    const Vec3 normal = planeOf(points).n;
    const Vec3 helper = std::abs(normal.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(helper, normal));
    const Vec3 v = glm::cross(normal, u);
    dat::Polygon polygon;
    polygon.sides = twoSided ? 1 : 0;
    polygon.stippling = dat::kRepeatPositive; // texture coordinates are metres
    polygon.posSurface = surface;
    for (const Vec3& p : points) {
        dat::Vertex vertex;
        vertex.position = Vec3f(p);
        vertex.normal = Vec3f(normal);
        vertex.uvs.push_back(Vec2f(static_cast<float>(glm::dot(p, u)), static_cast<float>(-glm::dot(p, v))));
        const auto key = static_cast<std::uint16_t>(vertices.vertices.size());
        vertices.vertices.emplace_back(key, vertex);
        polygon.vertexKeys.push_back(key);
        polygon.posUv.push_back(0);
    }
    const auto id = static_cast<std::uint16_t>(polygons.size());
    polygons.emplace_back(id, polygon);
    return id;
}

dat::BspTree leafTree() {
    dat::BspTree tree;
    tree.nodes.emplace_back();
    return tree;
}

dat::BspTree chainTree(std::span<const Plane> planes) {
    dat::BspTree tree;
    for (const Plane& plane : planes) {
        dat::BspNode node;
        node.tag = dat::BspTag::BPIn;
        node.plane = {Vec3f(plane.n), static_cast<float>(plane.d)};
        node.positive = static_cast<std::int32_t>(tree.nodes.size()) + 1;
        tree.nodes.push_back(node);
    }
    tree.nodes.emplace_back();
    return tree;
}

std::int16_t SurfaceSlots::slot(const std::string& name) {
    if (name.empty())
        return -1;
    const std::uint32_t id = idOf_(name);
    const auto found = std::find(ids_.begin(), ids_.end(), id);
    if (found == ids_.end())
        ids_.push_back(id);
    return static_cast<std::int16_t>(std::find(ids_.begin(), ids_.end(), id) - ids_.begin());
}

} // namespace limen::test
