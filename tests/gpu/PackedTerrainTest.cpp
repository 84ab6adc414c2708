#include "gpu/scene/PackedTerrain.h"

#include <gtest/gtest.h>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr layout::TerrainLayer kNone{layout::kNoTexture, layout::kNoTexture, 0, 1.0f};

layout::TerrainCell onlyBase(const layout::TerrainLayer& base) {
    layout::TerrainCell cell;
    cell.base = base;
    for (layout::TerrainLayer& overlay : cell.overlays)
        overlay = kNone;
    for (layout::TerrainLayer& road : cell.roads)
        road = kNone;
    return cell;
}

/// Texture n is in layer 10 n + 1 of page n.
std::vector<layout::TextureRef> refs(std::uint32_t count) {
    std::vector<layout::TextureRef> all(count);
    for (std::uint32_t i = 0; i < count; ++i)
        all[i].place = {10 * i + 1, i, 64, 64};
    return all;
}

/// Every map shows its layer in the first part alone.
std::vector<ShownParts> maps(std::size_t count) {
    return std::vector<ShownParts>(count, 1);
}

TEST(PackedTerrain, hasTheLayersThatExist_inOrder) {
    layout::TerrainCell cell = onlyBase({2, layout::kNoTexture, 0, 4.0f});
    cell.overlays[1] = {3, 5, 3, 2.0f};
    cell.roads[0] = {4, 6, 1, 1.0f};
    const std::vector<layout::PackedCell> packed = packTerrain({&cell, 1}, refs(7), maps(7));
    ASSERT_EQ(packed.size(), 1u);
    const layout::uvec4 &first = packed[0].layers[0], &second = packed[0].layers[1];
    EXPECT_EQ(first.x, 2u | 21u << 8 | 4u << layout::kPackedTiling);
    EXPECT_EQ(first.y, layout::kPackedLayer) << "a base has no blend map";
    EXPECT_EQ(first.z, 3u | 31u << 8 | 2u << layout::kPackedTiling);
    EXPECT_EQ(first.w,
              5u | 51u << 8 | 3u << layout::kPackedTurns | layout::kPackedLayer | layout::kPackedMap);
    EXPECT_EQ(second.x, 4u | 41u << 8 | 1u << layout::kPackedTiling);
    EXPECT_EQ(second.y,
              6u | 61u << 8 | 1u << layout::kPackedTurns | layout::kPackedLayer | layout::kPackedMap);
    EXPECT_EQ(second.z, 0u);
    EXPECT_EQ(second.w, 0u) << "no more layers";
}

TEST(PackedTerrain, holdsAllSixLayers) {
    layout::TerrainCell cell = onlyBase({0, layout::kNoTexture, 0, 1.0f});
    for (layout::TerrainLayer& overlay : cell.overlays)
        overlay = {1, 2, 0, 1.0f};
    for (layout::TerrainLayer& road : cell.roads)
        road = {1, 2, 0, 1.0f};
    const layout::PackedCell packed = packTerrain({&cell, 1}, refs(3), maps(3)).front();
    for (const layout::uvec4& pair : packed.layers) {
        EXPECT_NE(pair.y & layout::kPackedLayer, 0u);
        EXPECT_NE(pair.w & layout::kPackedLayer, 0u);
    }
}

TEST(PackedTerrain, aSecondRoadHasTheTextureOfTheFirst) {
    layout::TerrainCell cell = onlyBase({0, layout::kNoTexture, 0, 1.0f});
    cell.roads[0] = {1, 3, 0, 2.0f};
    cell.roads[1] = {2, 4, 1, 5.0f};
    const layout::PackedCell packed = packTerrain({&cell, 1}, refs(5), maps(5)).front();
    EXPECT_EQ(packed.layers[1].x, packed.layers[0].z) << "texture and repeats";
    EXPECT_EQ(packed.layers[1].y & layout::kPackedPlace & 0xFFu, 4u) << "its own map";
}

TEST(GroundPages, areThoseOfAllTexturesAndOfAllMaps) {
    layout::TerrainCell cell = onlyBase({0, layout::kNoTexture, 0, 1.0f});
    const auto pagesOf = [&](std::vector<TextureLocation> locations) {
        return groundPagesOf(groundTexturesOf({&cell, 1}), locations);
    };
    EXPECT_EQ(pagesOf({{7, 0}}), (GroundPages{7, 7})) << "no map";
    cell.overlays[2] = {1, 2, 0, 1.0f};
    EXPECT_EQ(pagesOf({{7, 0}, {7, 1}, {4, 0}}), (GroundPages{7, 4}));
    EXPECT_EQ(pagesOf({{7, 0}, {3, 1}, {4, 0}}), std::nullopt) << "two pages of textures";
    cell.roads[1] = {1, 3, 0, 1.0f};
    EXPECT_EQ(pagesOf({{7, 0}, {7, 1}, {4, 0}, {4, 1}}), (GroundPages{7, 4}));
    EXPECT_EQ(pagesOf({{7, 0}, {7, 1}, {4, 0}, {5, 0}}), std::nullopt) << "two pages of maps";
    EXPECT_EQ(groundPagesOf({}, {}), std::nullopt) << "no ground";
}

TEST(PackedTerrain, layersOfCommonPagesShowInThePartsOfTheirMaps) {
    std::vector<layout::TextureRef> pages(5);
    for (std::uint32_t i = 0; i < 5; ++i)
        pages[i].place = {i, i < 3 ? 0u : 1u, 64, 64}; // three textures, two maps
    layout::TerrainCell cell = onlyBase({0, layout::kNoTexture, 0, 4.0f});
    cell.overlays[0] = {1, 3, 0, 2.0f};
    cell.roads[0] = {2, 4, 2, 1.0f};
    const std::vector<ShownParts> parts{0, 0, 0, 1, 2};
    const auto shownOf = [&] {
        const layout::uvec4 pair = packTerrain({&cell, 1}, pages, parts).front().shown[0];
        return std::pair{pair.x | ShownParts{pair.y} << 32, pair.z | ShownParts{pair.w} << 32};
    };
    EXPECT_EQ(shownOf(), (std::pair{ShownParts{1}, ShownParts{1} << 62}))
        << "the second map is turned by half a turn";
    pages[2].place.y = 2;
    EXPECT_EQ(shownOf(), (std::pair{kEverywhere, kEverywhere})) << "another page for a texture";
    pages[2].place.y = 0;
    pages[4].place.y = 2;
    EXPECT_EQ(shownOf(), (std::pair{kEverywhere, kEverywhere})) << "another page for a map";
    pages[4].place.y = 1;
    cell.overlays[0].alpha = layout::kNoTexture;
    EXPECT_EQ(shownOf(), (std::pair{kEverywhere, kEverywhere})) << "a layer without a map";
}

TEST(PackedTerrain, repeatsAreWholeNumbersFrom1To255) {
    for (const auto& [tiling, packed] : {std::pair{0.2f, 1u}, {2.6f, 3u}, {1000.0f, 255u}}) {
        const layout::TerrainCell cell = onlyBase({0, layout::kNoTexture, 0, tiling});
        EXPECT_EQ(packTerrain({&cell, 1}, refs(1), maps(1)).front().layers[0].x >> layout::kPackedTiling,
                  packed);
    }
}

} // namespace
} // namespace limen::gpu
