#include "world/mesh/PolygonMesher.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"

namespace limen::world {
namespace {

Vec3f unitOr(const Vec3f& v, const Vec3f& fallback) {
    const float length = std::sqrt(glm::dot(v, v));
    return length > 1e-6f ? v / length : fallback;
}

} // namespace

void PolygonMesher::add(const BakedGeometry& geometry, std::uint32_t handle) {
    LIMEN_ASSERT(mesh_.polygonIds.size() < 0x10000, "polygon numbers are 16 bits wide");
    LIMEN_ASSERT(geometry.source(handle).isDrawn(), "portal polygons have no surface");
    const SourcePolygon& source = geometry.source(handle);
    mesh_.polygonIds.push_back(source.id);
    for (const StitchLoop& loop : geometry.loops(handle))
        addLoop(loop, source, geometry.vertices());
}

void PolygonMesher::addLoop(std::span<const StitchCorner> loop, const SourcePolygon& source,
                            std::span<const Vec3> vertices) {
    points_.clear();
    for (const StitchCorner& corner : loop)
        points_.push_back(vertices[corner.vertex]);
    triangles_.clear();
    triangulate(points_, triangles_);
    if (triangles_.empty())
        return;
    if (source.frontSlot >= 0)
        emitSide(loop, source.frontSlot, false);
    if (source.backSlot >= 0)
        emitSide(loop, source.backSlot, true);
}

void PolygonMesher::emitSide(std::span<const StitchCorner> loop, std::int32_t slot, bool back) {
    LIMEN_ASSERT(loop.size() == points_.size(), "points_ are the corners of this loop");
    const Vec3f flat(planeOf(points_).n);
    const auto slotIndex = static_cast<std::size_t>(slot);
    std::vector<std::uint32_t>& indices =
        mesh_.indicesOf(slotIndex < lists_.size() ? lists_[slotIndex] : SurfaceList::Opaque);
    for (const TriangleCorners& t : triangles_) {
        for (const std::uint32_t i : {t[0], back ? t[2] : t[1], back ? t[1] : t[2]}) {
            MeshVertex vertex;
            vertex.placeAt(points_[i]);
            vertex.normal = unitOr(loop[i].normal, flat) * (back ? -1.0f : 1.0f);
            vertex.uv = back ? loop[i].back : loop[i].front;
            vertex.polygon = static_cast<std::uint16_t>(mesh_.polygonIds.size() - 1);
            vertex.surface = static_cast<std::uint16_t>(slot);
            indices.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
            mesh_.vertices.push_back(vertex);
        }
    }
}

} // namespace limen::world
