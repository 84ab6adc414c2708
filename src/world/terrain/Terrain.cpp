#include "world/terrain/Terrain.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Heights of the block and of one landcell around it.
class Patch {
public:
    Patch(const Ground& ground, const HeightLookup& neighbours) : coord_(ground.coord) {
        for (int x = -1; x <= 9; ++x) {
            for (int y = -1; y <= 9; ++y) {
                const bool own = x >= 0 && y >= 0 && x <= 8 && y <= 8;
                at(x, y) = own ? std::optional(ground.heights[static_cast<std::size_t>(x * 9 + y)])
                               : neighbours(coord_.x * 8 + x, coord_.y * 8 + y);
            }
        }
    }

    [[nodiscard]] Vec3f normal(int x, int y) const {
        LIMEN_ASSERT(x >= 0 && y >= 0 && x <= 8 && y <= 8,
                     "the patch has the cells around the block's vertices");
        Vec3 sum(0.0);
        for (int cellX = x - 1; cellX <= x; ++cellX) {
            for (int cellY = y - 1; cellY <= y; ++cellY) {
                for (const auto& triangle : landcellTriangles(splits(cellX, cellY))) {
                    const bool touches =
                        std::any_of(triangle.begin(), triangle.end(), [&](const LandcellCorner& c) {
                            return cellX + c.x == x && cellY + c.y == y;
                        });
                    if (touches)
                        sum += faceNormal(cellX, cellY, triangle);
                }
            }
        }
        return Vec3f(glm::normalize(sum));
    }

private:
    std::optional<float>& at(int x, int y) {
        return heights_[static_cast<std::size_t>((x + 1) * 11 + y + 1)];
    }
    [[nodiscard]] const std::optional<float>& at(int x, int y) const {
        return heights_[static_cast<std::size_t>((x + 1) * 11 + y + 1)];
    }
    [[nodiscard]] bool splits(int cellX, int cellY) const {
        return splitsSouthWestNorthEast(coord_, cellX, cellY);
    }

    /// Zero if the height of a corner is unknown.
    [[nodiscard]] Vec3 faceNormal(int cellX, int cellY, const std::array<LandcellCorner, 3>& triangle) const {
        Vec3 p[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::optional<float>& z = at(cellX + triangle[i].x, cellY + triangle[i].y);
            if (!z)
                return Vec3(0.0);
            p[i] = {triangle[i].x * kLandcellSize, triangle[i].y * kLandcellSize, *z};
        }
        return glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    }

    dat::BlockCoord coord_;
    std::array<std::optional<float>, 121> heights_;
};

} // namespace

CellCorners Ground::corners(int x, int y) const {
    return {{type(x, y), type(x + 1, y), type(x + 1, y + 1), type(x, y + 1)},
            {road(x, y), road(x + 1, y), road(x + 1, y + 1), road(x, y + 1)}};
}

Ground groundOf(const dat::LandBlock& record, const dat::Region& region) {
    Ground ground;
    ground.coord = dat::blockOf(record.id);
    ground.words = record.terrain;
    for (std::size_t i = 0; i < 81; ++i) {
        const float z = region.landDefs.heights[record.heights[i]];
        ground.heights[i] = std::isfinite(z) ? std::clamp(z, -100000.0f, 100000.0f) : 0.0f;
    }
    return ground;
}

Ground landOf(Ground ground) {
    for (float& height : ground.heights)
        height = landHeight(height);
    return ground;
}

MeshData terrainMesh(const Ground& ground, const HeightLookup& neighbours) {
    const Patch patch(ground, neighbours);
    std::array<Vec3f, 81> normals;
    for (int i = 0; i < 81; ++i)
        normals[static_cast<std::size_t>(i)] = patch.normal(i / 9, i % 9);
    MeshData mesh;
    for (int cell = 0; cell < 64; ++cell) {
        const int cellX = cell / 8, cellY = cell % 8;
        for (const auto& triangle : landcellTriangles(splitsSouthWestNorthEast(ground.coord, cellX, cellY))) {
            for (const LandcellCorner& c : triangle) {
                const int x = cellX + c.x, y = cellY + c.y;
                const auto index = static_cast<std::size_t>(x * 9 + y);
                MeshVertex vertex;
                vertex.position = {static_cast<float>(x * 24), static_cast<float>(y * 24),
                                   ground.heights[index]};
                vertex.normal = normals[index];
                vertex.uv = {static_cast<float>(c.x), static_cast<float>(c.y)};
                vertex.polygon = static_cast<std::uint16_t>(mesh.polygonIds.size());
                vertex.surface = static_cast<std::uint16_t>(cell);
                mesh.indicesOf(SurfaceList::Opaque)
                    .push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
                mesh.vertices.push_back(vertex);
            }
            mesh.polygonIds.push_back(static_cast<std::uint16_t>(mesh.polygonIds.size()));
        }
    }
    return mesh;
}

} // namespace limen::world
