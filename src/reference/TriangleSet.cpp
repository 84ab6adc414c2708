#include "reference/TriangleSet.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"

#include <algorithm>
#include <cmath>

namespace limen::reference {
namespace {

constexpr std::uint32_t kTrianglesOfLeaf = 4; ///< at most this many triangles are tested one by one

Box boxOf(const Triangle& triangle) {
    Extent extent;
    for (const Vec3& corner : {triangle.a, triangle.b, triangle.c})
        extent.include(corner);
    return extent.box();
}

/// The index of the texel at a coordinate, along one side of an image.
std::uint32_t texelAt(double coordinate, std::uint32_t size, bool clamp) {
    const double within = clamp ? std::clamp(coordinate, 0.0, 1.0) : coordinate - std::floor(coordinate);
    return std::min(static_cast<std::uint32_t>(within * size), size - 1);
}

} // namespace

void TriangleSet::add(const world::World& world, const world::Instance& instance,
                      world::SurfaceClass surfaces, const Vec3& origin) {
    if (instance.mesh >= world.meshes.size())
        return;
    const world::Mesh& mesh = world.meshes[instance.mesh];
    const world::Mesh::Range& range = mesh.ranges[static_cast<std::size_t>(surfaces)];
    const Mat3 linear(instance.linear);
    const Vec3 at = world.blocks[instance.block].origin() + Vec3(instance.origin);
    // Through the global position, as for openings: a corner that a wall and an opening share gets the same
    // bits.
    const auto place = [&](const world::MeshVertex& v) { return (at + linear * v.corner()) - origin; };
    triangles_.reserve(triangles_.size() + range.indexCount / 3);
    for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; i += 3) {
        const auto vertex = [&](std::uint32_t k) -> const world::MeshVertex& {
            return world.vertices[mesh.firstVertex + world.indices[i + k]];
        };
        const world::MeshVertex &a = vertex(0), &b = vertex(1), &c = vertex(2);
        Triangle triangle{place(a), place(b), place(c), instance.idBase + a.polygon, world::kNone};
        if (surfaces == world::SurfaceClass::CutOut) {
            triangle.cutOut = static_cast<std::uint32_t>(cutOuts_.size());
            cutOuts_.push_back({a.uv, b.uv, c.uv, world.materialRefs[instance.firstMaterial + a.surface]});
        }
        triangles_.push_back(triangle);
    }
}

void TriangleSet::build(Grouping& grouping, Scratch& scratch) {
    const auto boxAll = [&] {
        scratch.boxes.clear();
        for (const Triangle& triangle : triangles_)
            scratch.boxes.push_back(boxOf(triangle));
    };
    if (!grouping.isKnown) {
        boxAll();
        grouping.tree.build(scratch.boxes, kTrianglesOfLeaf, grouping.order);
        grouping.isKnown = true;
    }
    LIMEN_ASSERT(grouping.order.size() == triangles_.size(), "a grouping is of the same mesh");
    scratch.triangles.assign(triangles_.begin(), triangles_.end());
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        triangles_[i] = scratch.triangles[grouping.order[i]];
    boxAll();
    tree_.fit(grouping.tree, scratch.boxes);
    box_ = {};
    for (const Box& box : scratch.boxes)
        box_.include(box);
    planes_.clear();
    for (const Triangle& triangle : triangles_) {
        const Vec3 corners[] = {triangle.a, triangle.b, triangle.c};
        planes_.push_back(planeOf(corners));
    }
}

void TriangleSet::clear() {
    triangles_.clear();
    planes_.clear();
    cutOuts_.clear();
    tree_.clear();
}

bool TriangleSet::isHole(const world::World& world, const Triangle& triangle, const Meeting& at) const {
    if (triangle.cutOut == world::kNone)
        return false;
    const CutOut& cut = cutOuts_[triangle.cutOut];
    const world::Material& material = world.materials[cut.material];
    if (material.texture == world::kNone)
        return false;
    const world::Image& image = *world.textures[material.texture];
    if (image.width == 0 || image.height == 0)
        return false;
    const Vec2 uv = Vec2(cut.a) * at.a + Vec2(cut.b) * at.b + Vec2(cut.c) * at.c;
    const bool clamp = (material.flags & world::Material::kClamp) != 0;
    const std::size_t texel =
        std::size_t{texelAt(uv.y, image.height, clamp)} * image.width + texelAt(uv.x, image.width, clamp);
    const bool indexed = (material.flags & world::Material::kIndexed) != 0;
    return image.rgba[texel * 4 + 3] / 255.0 < (indexed ? kCutOutAlphaIndexed : kCutOutAlpha);
}

void TriangleSet::findNearestGrown(const world::World& world, const RayFrame& ray, const BoxRay& boxRay,
                                   const Stretch& stretch, double margin, const GapTest& isGap,
                                   Nearest& nearest) const {
    const double farthest = std::min(stretch.most, nearest.t);
    tree_.walk(boxRay, stretch.after, farthest, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const Plane& plane = planes_[i];
            const double speed = glm::dot(plane.n, ray.direction);
            if (!(speed < 0.0))
                continue;
            const double t = -plane.signedDistance(ray.eye) / speed;
            if (!(t > stretch.after && t >= stretch.least && t <= std::min(stretch.most, nearest.t)))
                continue;
            const Triangle& triangle = triangles_[i];
            const Vec3 corners[] = {triangle.a, triangle.b, triangle.c}, p = ray.eye + ray.direction * t;
            if (beginsInPlane(ray, triangle) || !containsProjection(corners, plane.n, p, margin) ||
                !isGap(p, corners))
                continue;
            // Weights by areas. Beside the triangle they are slightly outside 0..1, and so is the texture
            // coordinate.
            const Vec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
            const double whole = glm::dot(normal, normal);
            const double b = glm::dot(glm::cross(p - triangle.a, triangle.c - triangle.a), normal) / whole;
            const double c = glm::dot(glm::cross(triangle.b - triangle.a, p - triangle.a), normal) / whole;
            if (!isHole(world, triangle, {t, 1.0 - b - c, b, c}))
                nearest.take(t, triangle.id);
        }
    });
}

} // namespace limen::reference
