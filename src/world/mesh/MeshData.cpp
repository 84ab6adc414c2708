#include "world/mesh/MeshData.h"

#include "core/Assert.h"

namespace limen::world {

MeshData blendedMesh(const MeshData& mesh) {
    MeshData out = mesh;
    std::vector<std::uint32_t>& blended = out.indicesOf(SurfaceList::Blended);
    for (const SurfaceList list : {SurfaceList::Opaque, SurfaceList::CutOut, SurfaceList::Split}) {
        std::vector<std::uint32_t>& from = out.indicesOf(list);
        blended.insert(blended.end(), from.begin(), from.end());
        from.clear();
    }
    LIMEN_ASSERT(blended.size() == mesh.vertices.size(), "every vertex is in exactly one index list");
    return out;
}

MeshData spriteMesh(SurfaceList surfaces, const Vec2f& low, const Vec2f& high) {
    MeshData mesh;
    const std::array<Vec2f, 4> corners{Vec2f(0, 1), Vec2f(1, 1), Vec2f(1, 0), Vec2f(0, 0)};
    for (const std::size_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
        const Vec2f& corner = corners[i];
        const Vec3f at(low.x + corner.x * (high.x - low.x), 0.0f, high.y + corner.y * (low.y - high.y));
        mesh.indicesOf(surfaces).push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back({at, Vec3f(0.0f, -1.0f, 0.0f), corner, 0, 0, Vec3f(0.0f)});
    }
    mesh.polygonIds.push_back(0);
    return mesh;
}

} // namespace limen::world
