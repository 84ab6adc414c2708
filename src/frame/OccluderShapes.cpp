#include "frame/OccluderShapes.h"

#include "frame/ResidentPieces.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace limen::frame {

namespace {

/// The most by which rounding to floats moves a coordinate, as a share of its distance from the origin, with a margin.
constexpr double kRounding = 1e-6;

bool canHide(const world::World& world, const world::Instance& instance) {
    const DrawClass drawn = solidClassOf(instance.kind);
    return (drawn == DrawClass::Wall || drawn == DrawClass::Terrain) && instance.block != world::kNone &&
           world.meshes[instance.mesh].ranges[0].indexCount > 0;
}

/// Corners with equal coordinates get one number.
OccluderShapes::Shape shapeOf(const world::World& world, const world::Mesh& mesh) {
    const std::span<const std::uint32_t> indices =
        std::span(world.indices).subspan(mesh.ranges[0].firstIndex, mesh.ranges[0].indexCount);
    const auto at = [&](std::size_t i) -> const Vec3f& {
        return world.vertices[mesh.firstVertex + indices[i]].position;
    };
    std::vector<std::uint32_t> order(indices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto isBefore = [&](std::uint32_t a, std::uint32_t b) {
        const Vec3f &p = at(a), &q = at(b);
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    OccluderShapes::Shape shape;
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (!isFinite(Vec3(at(i))))
            return shape; // has no order, and hides nothing
    std::sort(order.begin(), order.end(), isBefore);
    shape.triangles.resize(indices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || isBefore(order[i - 1], order[i]))
            shape.corners.push_back(at(order[i]));
        shape.triangles[order[i]] = static_cast<std::uint32_t>(shape.corners.size() - 1);
    }
    return shape;
}

Aabb boxOf(const world::World& world, const world::Mesh& mesh) {
    Aabb box;
    for (const world::MeshVertex& vertex :
         std::span(world.vertices).subspan(mesh.firstVertex, mesh.vertexCount))
        box.include(Vec3(vertex.position));
    return box;
}

} // namespace

OccluderShapes::OccluderShapes(const world::World& world, const Clusters& clusters) {
    addOccluders(world);
    addBoxes(world, clusters);
}

void OccluderShapes::addOccluders(const world::World& world) {
    if (world.spaces.empty())
        return;
    std::vector<std::uint32_t> shapes(world.meshes.size(), world::kNone);
    const world::Space& outside = world.spaces[world::kOutside];
    for (const world::InstanceIndex index :
         std::span(world.spaceInstances).subspan(outside.firstInstance, outside.instanceCount)) {
        const world::Instance& instance = world.instances[index];
        if (!canHide(world, instance))
            continue;
        std::uint32_t& shape = shapes[instance.mesh];
        if (shape == world::kNone) {
            shape = static_cast<std::uint32_t>(shapes_.size());
            shapes_.push_back(shapeOf(world, world.meshes[instance.mesh]));
        }
        occluders_.push_back({index, shape});
    }
}

void OccluderShapes::addBoxes(const world::World& world, const Clusters& clusters) {
    std::vector<Aabb> boxes;
    boxes.reserve(world.meshes.size());
    for (const world::Mesh& mesh : world.meshes)
        boxes.push_back(boxOf(world, mesh));
    if (!clusters.bounds.empty())
        origin_ = glm::floor(clusters.bounds.front().centre);
    boxes_.reserve(clusters.order.size());
    for (const world::InstanceIndex index : clusters.order) {
        const world::Instance& instance = world.instances[index];
        const Aabb& box = boxes[instance.mesh];
        if (box.empty() || instance.facing != world::Facing::Fixed) { // turned to the eye in any direction
            boxes_.push_back({Vec3f(instance.bounds.centre - origin_),
                              Vec3f(static_cast<float>(std::abs(instance.bounds.radius)))});
            continue;
        }
        const Vec3 block = instance.block != world::kNone ? world.blocks[instance.block].origin() : Vec3(0.0);
        const Mat3 linear(instance.linear);
        const Vec3 centre = block + Vec3(instance.origin) + linear * box.centre() - origin_;
        const Vec3 half = 0.5 * (box.max - box.min);
        Vec3 extent = kRounding * (glm::abs(centre) + half);
        for (int i = 0; i < 3; ++i)
            extent += glm::abs(linear[i]) * half[i];
        boxes_.push_back({Vec3f(centre), Vec3f(extent)});
    }
}

} // namespace limen::frame
