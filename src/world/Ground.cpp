#include "world/Ground.h"

#include "core/Assert.h"
#include "world/LandRandom.h"

#include <algorithm>
#include <cmath>

namespace limen::world {

bool splitsSouthWestNorthEast(dat::BlockCoord block, int cellX, int cellY) {
    return splitsSouthWestNorthEast(static_cast<std::uint32_t>(block.x * 8 + cellX),
                                    static_cast<std::uint32_t>(block.y * 8 + cellY));
}

LandcellTriangles landcellTriangles(bool southWestNorthEast) {
    constexpr LandcellCorner kSw{0, 0}, kSe{1, 0}, kNe{1, 1}, kNw{0, 1};
    if (southWestNorthEast)
        return {{{kSw, kSe, kNe}, {kSw, kNe, kNw}}};
    return {{{kSw, kSe, kNw}, {kNe, kNw, kSe}}};
}

GroundPoint groundAt(dat::BlockCoord block, std::span<const float> heights, double x, double y) {
    LIMEN_ASSERT(heights.size() == 81, "a block has 9 x 9 heights");
    const int cellX = std::clamp(static_cast<int>(std::floor(x / kLandcellSize)), 0, 7);
    const int cellY = std::clamp(static_cast<int>(std::floor(y / kLandcellSize)), 0, 7);
    const double u = std::clamp(x / kLandcellSize - cellX, 0.0, 1.0),
                 v = std::clamp(y / kLandcellSize - cellY, 0.0, 1.0);
    const bool southWestNorthEast = splitsSouthWestNorthEast(block, cellX, cellY);
    const LandcellTriangles triangles = landcellTriangles(southWestNorthEast);
    const bool first = southWestNorthEast ? v <= u : u + v <= 1.0;
    Vec3 p[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const LandcellCorner c = triangles[first ? 0 : 1][i];
        const auto index = static_cast<std::size_t>((cellX + c.x) * 9 + cellY + c.y);
        p[i] = {c.x * kLandcellSize, c.y * kLandcellSize, heights[index]};
    }
    const Vec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    const Vec3 at(u * kLandcellSize, v * kLandcellSize, 0.0);
    return {p[0].z - (n.x * (at.x - p[0].x) + n.y * (at.y - p[0].y)) / n.z, n};
}

} // namespace limen::world
