#include "world/SkyCover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace limen::world {
namespace {

using Corner = std::array<float, 3>;
/// Uses of an edge in its direction, less those in the other one; the lesser corner comes first.
using Edges = std::map<std::pair<Corner, Corner>, int>;

/// Near the zenith, beside the vertices that domes have there.
const Vec3 kProbe(0.0123, 0.0071, 1.0);
/// Sine: directions this near a rim count as uncovered.
constexpr double kMargin = 1e-4;

void addEdge(const Vec3f& from, const Vec3f& to, Edges& edges) {
    const Corner a{from.x, from.y, from.z}, b{to.x, to.y, to.z};
    if (a < b)
        ++edges[{a, b}];
    else if (b < a)
        --edges[{b, a}];
}

/// Positive if the direction `of` is to the left of the edge, seen from the origin.
double sideOf(const Vec3& from, const Vec3& to, const Vec3& of) {
    return glm::dot(glm::cross(to, from), of);
}

double elevationSine(const Corner& corner) {
    const Vec3 at(corner[0], corner[1], corner[2]);
    return at.z / glm::length(at);
}

/// The triangles of a part, three corners each.
std::vector<Vec3f> cornersOf(const World& world, const SkyPart& part) {
    std::vector<Vec3f> corners;
    const Mesh& mesh = world.meshes[part.mesh];
    for (const Mesh::Range& range : mesh.ranges)
        for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; ++i)
            corners.push_back(world.vertices[mesh.firstVertex + world.indices[i]].position);
    return corners;
}

/// As shaders/skyobjects.frag blends a surface of any class.
bool isOpaque(const World& world, const Material& material) {
    return (material.flags & (Material::kAdditive | Material::kInvAlpha)) == 0 && material.colour.w >= 1.0f &&
           (material.texture == kNone || !world.textures[material.texture]->hasAlpha);
}

bool isOpaque(const World& world, const SkyPart& part) {
    const Mesh& mesh = world.meshes[part.mesh];
    const std::span vertices = std::span(world.vertices).subspan(mesh.firstVertex, mesh.vertexCount);
    return std::all_of(vertices.begin(), vertices.end(), [&](const MeshVertex& vertex) {
        return isOpaque(world, world.materials[world.materialRefs[part.firstMaterial + vertex.surface]]);
    });
}

bool isCover(const Sky& sky, const SkyPlacement& placement) {
    return sky.parts[placement.part].isOpaque && placement.transparent <= 0.0f && !placement.isOverLand;
}

} // namespace

// Seen from the origin, all triangles turn the same way. So the number of them in a direction changes only at edges that one
// triangle has alone. Above the highest of these it is the number at the probe. An edge between corners below the horizon
// has no higher point than its corners.
double coveredFrom(std::span<const Vec3f> corners) {
    Edges edges;
    bool hasProbe = false;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const Vec3 a(corners[i]), b(corners[i + 1]), c(corners[i + 2]);
        if (sideOf(a, b, c) < 0.0)
            return SkyPart::kCoversNothing;
        hasProbe = hasProbe ||
                   (sideOf(a, b, kProbe) > 0.0 && sideOf(b, c, kProbe) > 0.0 && sideOf(c, a, kProbe) > 0.0);
        for (std::size_t side = 0; side < 3; ++side)
            addEdge(corners[i + side], corners[i + (side + 1) % 3], edges);
    }
    double highest = -1.0;
    for (const auto& [edge, uses] : edges)
        if (uses != 0)
            highest = std::max({highest, elevationSine(edge.first), elevationSine(edge.second)});
    return hasProbe && highest < 0.0 ? highest + kMargin : SkyPart::kCoversNothing; // also for NaN
}

void findSkyCover(World& world) {
    std::vector<std::vector<Vec3f>> shapes;
    for (SkyPart& part : world.sky.parts) {
        shapes.push_back(cornersOf(world, part));
        part.shape = static_cast<std::uint32_t>(std::find(shapes.begin(), shapes.end(), shapes.back()) -
                                                shapes.begin());
        part.isOpaque = isOpaque(world, part);
        part.coversFrom = part.isOpaque ? coveredFrom(shapes.back()) : SkyPart::kCoversNothing;
    }
}

void leaveOutCovered(const Sky& sky, std::vector<SkyPlacement>& placements) {
    const auto isCovered = [&](const SkyPlacement& placement) {
        const auto later =
            std::span(placements).subspan(static_cast<std::size_t>(&placement - placements.data()) + 1);
        return !placement.isOverLand &&
               std::any_of(later.begin(), later.end(), [&](const SkyPlacement& other) {
                   return isCover(sky, other) &&
                          sky.parts[other.part].shape == sky.parts[placement.part].shape &&
                          other.rotation == placement.rotation && other.offset == placement.offset;
               });
    };
    // Tests read later elements alone, and an element is overwritten after its own test.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < placements.size(); ++i)
        if (!isCovered(placements[i]))
            placements[kept++] = placements[i];
    placements.resize(kept);
}

double coveredFrom(const Sky& sky, std::span<const SkyPlacement> placements) {
    double from = SkyPart::kCoversNothing;
    for (const SkyPlacement& placement : placements) {
        const glm::mat3& turn = placement.rotation;
        const bool isLevel = turn[0].z == 0.0f && turn[1].z == 0.0f && turn[2].z == 1.0f;
        if (isLevel && placement.offset == Vec3f(0.0f) && isCover(sky, placement))
            from = std::min(from, sky.parts[placement.part].coversFrom);
    }
    return from;
}

} // namespace limen::world
