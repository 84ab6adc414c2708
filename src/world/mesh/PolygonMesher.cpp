#include "world/mesh/PolygonMesher.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"

namespace limen::world {
namespace {

Vec3f unitOrZero(const Vec3f& v) {
    const float length = std::sqrt(glm::dot(v, v));
    return length > 1e-6f ? v / length : Vec3f(0.0f);
}

} // namespace

void PolygonMesher::add(const BakedGeometry& geometry, std::uint32_t handle) {
    LIMEN_ASSERT(mesh_.polygonIds.size() < 0x10000, "polygon numbers are 16 bits wide");
    const SourcePolygon& source = geometry.source(handle);
    LIMEN_ASSERT(source.isDrawn(), "one of its sides has a surface");
    noteRepeat(source.frontSlot, source.frontRepeats);
    noteRepeat(source.backSlot, source.backRepeats);
    if (source.isPortal)
        mesh_.inOpenings.push_back(static_cast<std::uint16_t>(mesh_.polygonIds.size()));
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
        emitSide(loop, source.frontSlot, Side::Front);
    if (source.backSlot >= 0)
        emitSide(loop, source.backSlot, source.backIsLitAsFront ? Side::BackLitAsFront : Side::Back);
}

void PolygonMesher::noteRepeat(std::int32_t slot, bool repeats) {
    if (slot >= 0 && static_cast<std::size_t>(slot) < clamped_.size() && repeats)
        clamped_[static_cast<std::size_t>(slot)] = false;
}

void PolygonMesher::emitSide(std::span<const StitchCorner> loop, std::int32_t slot, Side side) {
    LIMEN_ASSERT(loop.size() == points_.size(), "points_ are the corners of this loop");
    const bool back = side != Side::Front;
    const float sign = side == Side::Back ? -1.0f : 1.0f;
    const auto slotIndex = static_cast<std::size_t>(slot);
    std::vector<std::uint32_t>& indices =
        mesh_.indicesOf(slotIndex < lists_.size() ? lists_[slotIndex] : SurfaceList::Opaque);
    for (const TriangleCorners& t : triangles_) {
        for (const std::uint32_t i : {t[0], back ? t[2] : t[1], back ? t[1] : t[2]}) {
            MeshVertex vertex;
            vertex.placeAt(points_[i]);
            vertex.normal = unitOrZero(loop[i].normal) * sign;
            vertex.uv = back ? loop[i].back : loop[i].front;
            vertex.polygon = static_cast<std::uint16_t>(mesh_.polygonIds.size() - 1);
            vertex.surface = static_cast<std::uint16_t>(slot);
            indices.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
            mesh_.vertices.push_back(vertex);
        }
    }
}

} // namespace limen::world
