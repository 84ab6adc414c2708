#include "gpu/scene/BlendMapParts.h"

#include <gtest/gtest.h>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

/// A square map that keeps the layer below, but for some texels.
struct Map {
    explicit Map(std::uint32_t side) : size(side), rgba(std::size_t{4} * side * side, 255) {}
    void show(std::uint32_t x, std::uint32_t y, std::uint8_t alpha = 254) {
        rgba[4 * (std::size_t{y} * size + x) + 3] = alpha;
    }
    [[nodiscard]] ShownParts parts() const { return partsOf({size, size, rgba, true, 0}); }
    std::uint32_t size;
    std::vector<std::uint8_t> rgba;
};

ShownParts partAt(std::uint32_t x, std::uint32_t y) {
    return ShownParts{1} << (y * layout::kShownParts + x);
}

TEST(BlendMapParts, aTexelShowsInItsPart) {
    Map map(64);
    EXPECT_EQ(map.parts(), 0u);
    map.show(3 * 8 + 4, 5 * 8 + 4);
    EXPECT_EQ(map.parts(), partAt(3, 5));
}

TEST(BlendMapParts, twoTexelsBesideAPartCountForIt) {
    for (const std::uint32_t away : {0u, 1u, 2u}) {
        Map map(64);
        map.show(3 * 8 + away, 5 * 8 + 4); // from the left edge of a part
        EXPECT_EQ(map.parts(), away < 2 ? partAt(3, 5) | partAt(2, 5) : partAt(3, 5)) << away;
    }
}

TEST(BlendMapParts, mapsOfAnySizeHaveAllParts) {
    for (const std::uint32_t size : {1u, 3u, 8u, 100u}) {
        Map map(size);
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x)
                map.show(x, y, 0);
        EXPECT_EQ(map.parts(), kEverywhere) << size;
    }
}

// terrainblend.glsl reads a turned map at (-y, x) about its middle.
TEST(BlendMapParts, turnsLikeTheMap) {
    EXPECT_EQ(turned(partAt(6, 1), 0), partAt(6, 1));
    EXPECT_EQ(turned(partAt(6, 1), 1), partAt(1, 1)); // x = 1, y = 1: read at (7 - 1, 1)
    EXPECT_EQ(turned(partAt(6, 1), 2), partAt(1, 6));
    EXPECT_EQ(turned(partAt(6, 1), 3), partAt(6, 6));
    const ShownParts any = 0x0123456789ABCDEFu;
    EXPECT_EQ(turned(turned(any, 1), 3), any);
    EXPECT_EQ(turned(any, 5), turned(any, 1));
}

TEST(BlendMapParts, onlyMapsOfLayersAreRead) {
    Map shown(64);
    shown.show(0, 0);
    const std::vector<frame::TextureUpload> textures(3, frame::TextureUpload{64, 64, shown.rgba, true, 0});
    constexpr layout::TerrainLayer kNone{layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
    layout::TerrainCell cell{
        {0, layout::kNoTexture, 0, 1.0f}, {kNone, {0, 2, 0, 1.0f}, kNone}, {kNone, kNone}};
    EXPECT_EQ(partsOfMaps({&cell, 1}, textures), (std::vector<ShownParts>{0, 0, partAt(0, 0)}));
}

} // namespace
} // namespace limen::gpu
