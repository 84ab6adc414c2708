#include "world/mesh/MeshArena.h"

#include "core/Assert.h"
#include "geometry/Tolerances.h"

#include <algorithm>
#include <bit>

namespace limen::world {

namespace {

/// Computed in double: triangles may be long and thin.
void setFacets(std::span<MeshVertex> vertices) {
    LIMEN_ASSERT(vertices.size() % 3 == 0, "vertices come in threes");
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const Vec3 origin = vertices[i].corner();
        const Vec3 normal = glm::cross(vertices[i + 1].corner() - origin, vertices[i + 2].corner() - origin);
        const double length = glm::length(normal);
        const Vec3f facet = length > 0.0 ? Vec3f(normal / length) : Vec3f(0.0f);
        for (std::size_t k = 0; k < 3; ++k)
            vertices[i + k].facet = facet;
    }
}

/// An edge from corner to corner. Two edges are equal if their corners are, bit for bit.
struct Edge {
    std::array<double, 6> ends{};
    bool operator==(const Edge&) const = default;

    Edge(const Vec3& from, const Vec3& to) : ends{from.x, from.y, from.z, to.x, to.y, to.z} {}
};

struct EdgeHash {
    std::size_t operator()(const Edge& edge) const {
        std::uint64_t hash = 0;
        for (const double v : edge.ends)
            hash = (hash ^ hash >> 29) * 0x9E3779B97F4A7C15u + std::bit_cast<std::uint64_t>(v);
        return static_cast<std::size_t>(hash ^ hash >> 29);
    }
};

/// Metres. Surfaces of a cell beyond a wall may be this near to the wall's plane if the walls of both cells
/// are flat. Records store corners as floats, with errors of 0.001 mm within 16 m of a cell's origin and
/// 0.004 mm within 64 m. Subtracting the eye adds the same again.
constexpr double kFlatReach = 1e-5;
/// The same at most, however uneven walls are. A surface that is rightly seen beside such an edge may be as near to it.
constexpr double kMostReach = kOverlapTolerance;

/// The facet of each polygon's largest triangle. Facets of slivers are dominated by rounding.
std::vector<Vec3f> facetsByPolygon(std::span<const MeshVertex> vertices, std::size_t polygons) {
    std::vector<Vec3f> facets(polygons, Vec3f(0.0f));
    std::vector<double> areas(polygons, 0.0);
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const MeshVertex& first = vertices[i];
        const Vec3 origin = first.corner();
        const double area =
            glm::length(glm::cross(vertices[i + 1].corner() - origin, vertices[i + 2].corner() - origin));
        if (area > areas[first.polygon]) {
            areas[first.polygon] = area;
            facets[first.polygon] = first.facet;
        }
    }
    return facets;
}

/// The greatest distance of a corner from its polygon's facet, metres. Records may have corners off their
/// planes, for example on a grid. Then cells that share a wall cut it into triangles that are not in one
/// plane.
double unevennessOf(std::span<const MeshVertex> vertices, std::span<const Vec3f> facets) {
    std::vector<double> low(facets.size(), 1e300), high(facets.size(), -1e300);
    for (const MeshVertex& vertex : vertices) {
        const double height = glm::dot(Vec3(facets[vertex.polygon]), vertex.corner());
        low[vertex.polygon] = std::min(low[vertex.polygon], height);
        high[vertex.polygon] = std::max(high[vertex.polygon], height);
    }
    double most = 0.0;
    for (std::size_t i = 0; i < facets.size(); ++i)
        most = std::max(most, high[i] - low[i]);
    return most;
}

/// Stitched polygons share whole edges. The back of a two-sided polygon has no neighbour. Polygons in openings are
/// no walls: a ray may come through them from another cell of the zone.
void setNeighbourFacets(std::span<MeshVertex> vertices, std::size_t polygons,
                        std::span<const std::uint16_t> inOpenings) {
    const auto isWall = [&](const MeshVertex& vertex) {
        return !std::binary_search(inOpenings.begin(), inOpenings.end(), vertex.polygon);
    };
    const std::vector<Vec3f> facets = facetsByPolygon(vertices, polygons);
    const double reach = std::min(kFlatReach + 2.0 * unevennessOf(vertices, facets), kMostReach);
    const auto perReach = static_cast<float>(1.0 / reach);
    std::unordered_map<Edge, std::uint16_t, EdgeHash> byEdge;
    const auto next = [](std::size_t i) { return i % 3 == 2 ? i - 2 : i + 1; };
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (isWall(vertices[i]))
            byEdge.try_emplace(Edge(vertices[i].corner(), vertices[next(i)].corner()), vertices[i].polygon);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (!isWall(vertices[i]))
            continue;
        const auto found = byEdge.find(Edge(vertices[next(i)].corner(), vertices[i].corner()));
        if (found != byEdge.end() && found->second != vertices[i].polygon)
            vertices[i].neighbour = facets[found->second] * perReach;
    }
}

} // namespace

std::uint32_t MeshArena::add(const MeshData& data, std::uint64_t key) {
    Mesh mesh;
    mesh.contentKey = key;
    mesh.firstVertex = static_cast<std::uint32_t>(world_.vertices.size());
    mesh.vertexCount = static_cast<std::uint32_t>(data.vertices.size());
    mesh.polygonCount = static_cast<std::uint32_t>(data.polygonIds.size());
    mesh.firstPolygonInfo = static_cast<std::uint32_t>(world_.polygonIds.size());
    auto firstIndex = static_cast<std::uint32_t>(world_.indices.size());
    for (const std::vector<std::uint32_t>& list : data.indices)
        world_.indices.insert(world_.indices.end(), list.begin(), list.end());
    const auto sizeOf = [&data](SurfaceList list) {
        return static_cast<std::uint32_t>(data.indices[static_cast<std::size_t>(list)].size());
    };
    mesh.splitIndexCount = sizeOf(SurfaceList::Split);
    const std::array<std::uint32_t, 3> counts{sizeOf(SurfaceList::Opaque), sizeOf(SurfaceList::CutOut),
                                              mesh.splitIndexCount + sizeOf(SurfaceList::Blended)};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        mesh.ranges[i] = {firstIndex, counts[i]};
        firstIndex += counts[i];
    }
    LIMEN_ASSERT(firstIndex == world_.indices.size(), "the ranges cover all indices of the mesh");
    LIMEN_ASSERT(firstIndex - mesh.ranges[0].firstIndex == mesh.vertexCount,
                 "no two triangles share a vertex, and none is unused");
    std::vector<Vec3> points;
    points.reserve(data.vertices.size());
    for (const MeshVertex& vertex : data.vertices)
        points.push_back(vertex.corner());
    mesh.bounds = boundingSphere(points);
    world_.vertices.insert(world_.vertices.end(), data.vertices.begin(), data.vertices.end());
    const std::span<MeshVertex> own = std::span(world_.vertices).subspan(mesh.firstVertex);
    setFacets(own);
    world_.polygonIds.insert(world_.polygonIds.end(), data.polygonIds.begin(), data.polygonIds.end());
    world_.meshes.push_back(mesh);
    return static_cast<std::uint32_t>(world_.meshes.size() - 1);
}

void MeshArena::setNeighbours(std::uint32_t shell, std::span<const std::uint16_t> inOpenings) {
    LIMEN_ASSERT(shell < world_.meshes.size(), "the shell is in the arena");
    const Mesh& mesh = world_.meshes[shell];
    setNeighbourFacets(std::span(world_.vertices).subspan(mesh.firstVertex, mesh.vertexCount),
                       mesh.polygonCount, inOpenings);
}

std::uint32_t MeshArena::shared(const PartMesh& part) {
    const std::uint64_t key = contentKey(MeshSource::GfxObj, part.gfxObj);
    const auto [entry, fresh] = byContent_.try_emplace(key, kNone);
    if (fresh)
        entry->second = add(part.mesh, key);
    return entry->second;
}

} // namespace limen::world
