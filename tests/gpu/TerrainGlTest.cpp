#include "GlFixture.h"

#include <cmath>

namespace limen::gpu::test {
namespace {

/// A way of drawing the ground. `severalPages`: its textures have several sizes, so that no page holds all.
struct GroundWay {
    const char* name;
    Drawing drawing = Drawing::Exact;
    bool severalPages = false;
};

// A landcell upright before the camera: x is east, z is north; one pixel per 1/8 of the cell.
class TerrainGlTest : public GlTest, public ::testing::WithParamInterface<GroundWay> {
protected:
    static constexpr std::uint32_t kSize = 8;

    Frame drawCell(SceneBuilder& scene, const layout::TerrainCell& cell) {
        scene.root(0);
        scene.upload.terrainCells.push_back(cell);
        QuadOptions options;
        options.program = frame::Program::Terrain;
        options.material = static_cast<std::uint32_t>(scene.upload.terrainCells.size() - 1);
        options.uv = {
            glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}; // position in the cell, south-west corner first
        scene.addWall('T', {-2, -2}, {2, 2}, 2, options);
        return render(scene, kSize, {.drawing = GetParam().drawing});
    }
    static std::uint32_t plain(SceneBuilder& scene, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
        if (!GetParam().severalPages || scene.upload.textures.size() % 2 == 0)
            return scene.addTexture(1, 1, {r, g, b, 255}, false);
        return scene.addTexture(2, 2, {r, g, b, 255, r, g, b, 255, r, g, b, 255, r, g, b, 255}, false);
    }
    // 8 x 8 texels, one per pixel; alpha grows eastwards and, a little, southwards.
    static std::uint8_t alphaAt(std::uint32_t column, std::uint32_t row) {
        return static_cast<std::uint8_t>(30 * column + row * 2 + 10);
    }
    static std::uint32_t rampMap(SceneBuilder& scene) {
        std::vector<std::uint8_t> rgba;
        for (std::uint32_t row = 0; row < kSize; ++row)
            for (std::uint32_t column = 0; column < kSize; ++column)
                rgba.insert(rgba.end(), {0, 0, 0, alphaAt(column, row)});
        return scene.addTexture(kSize, kSize, rgba, true);
    }
    static layout::TerrainLayer layer(std::uint32_t texture, std::uint32_t alpha = layout::kNoTexture,
                                      std::uint32_t rotation = 0) {
        return {texture, alpha, rotation, 1.0f};
    }
    static layout::TerrainCell only(layout::TerrainLayer base) {
        const layout::TerrainLayer none = layer(layout::kNoTexture);
        return {base, {none, none, none}, {none, none}};
    }
    static void expectNear(glm::ivec3 actual, glm::dvec3 expected, const std::string& where) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(actual[c], expected[c], 1.01) << where << " channel " << c;
    }
};

TEST_P(TerrainGlTest, overlay_showsWhereItsAlphaIsLow_inEachRotation) {
    for (std::uint32_t rotation = 0; rotation < 4; ++rotation) {
        SceneBuilder scene;
        const std::uint32_t base = plain(scene, 200, 0, 40), over = plain(scene, 0, 100, 40);
        layout::TerrainCell cell = only(layer(base));
        cell.overlays[0] = layer(over, rampMap(scene), rotation);
        const Frame frame = drawCell(scene, cell);
        for (std::uint32_t y = 0; y < kSize; ++y) {
            for (std::uint32_t x = 0; x < kSize; ++x) {
                const std::uint32_t last = kSize - 1;
                // r1: (1-v, u); r2: (1-u, 1-v); r3: (v, 1-u), with u = x and v = y (row 0 north).
                const std::array<std::array<std::uint32_t, 2>, 4> texel{
                    {{x, y}, {last - y, x}, {last - x, last - y}, {y, last - x}}};
                const double keep = alphaAt(texel[rotation][0], texel[rotation][1]) / 255.0;
                expectNear(frame.at(x, y),
                           glm::dvec3(200, 0, 40) * keep + glm::dvec3(0, 100, 40) * (1 - keep),
                           "rotation " + std::to_string(rotation) + " pixel " + std::to_string(x) + "," +
                               std::to_string(y));
            }
        }
    }
}

TEST_P(TerrainGlTest, overlay_isWithinAStepOfTheOriginalsIntegers) {
    SceneBuilder scene;
    constexpr std::array<int, 3> kBase{200, 3, 40}, kOver{0, 100, 255};
    const std::uint32_t base = plain(scene, 200, 3, 40), over = plain(scene, 0, 100, 255);
    layout::TerrainCell cell = only(layer(base));
    cell.overlays[0] = layer(over, rampMap(scene), 0);
    const Frame frame = drawCell(scene, cell);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const int alpha = alphaAt(x, y), a = alpha > 127 ? alpha + 1 : alpha;
            for (std::size_t c = 0; c < 3; ++c) {
                const int merged = (kOver[c] * (256 - a) + kBase[c] * a) >> 8;
                EXPECT_LE(std::abs(frame.at(x, y)[static_cast<int>(c)] - merged), 1)
                    << "alpha " << alpha << " channel " << c;
            }
        }
    }
}

TEST_P(TerrainGlTest, threeOverlaysAndTwoRoads_arePaintedInOrder) {
    SceneBuilder scene;
    const std::array<std::uint32_t, 4> overlays{plain(scene, 250, 0, 0), plain(scene, 0, 250, 0),
                                                plain(scene, 0, 0, 250), plain(scene, 90, 80, 70)};
    const std::uint32_t road = plain(scene, 20, 30, 10), map = rampMap(scene);
    layout::TerrainCell cell = only(layer(overlays[3]));
    for (std::uint32_t i = 0; i < 3; ++i)
        cell.overlays[i] = layer(overlays[i], map, i);
    cell.roads[0] = layer(road, map, 3);
    cell.roads[1] = layer(road, map, 1);
    const Frame frame = drawCell(scene, cell);
    for (const auto& [x, y] : {std::pair{0u, 0u}, {7u, 0u}, {3u, 5u}, {6u, 7u}}) {
        const std::array<double, 4> keep{alphaAt(x, y) / 255.0, alphaAt(7 - y, x) / 255.0,
                                         alphaAt(7 - x, 7 - y) / 255.0, alphaAt(y, 7 - x) / 255.0};
        glm::dvec3 colour(90, 80, 70);
        colour = colour * keep[0] + glm::dvec3(250, 0, 0) * (1 - keep[0]);
        colour = colour * keep[1] + glm::dvec3(0, 250, 0) * (1 - keep[1]);
        colour = colour * keep[2] + glm::dvec3(0, 0, 250) * (1 - keep[2]);
        const double kept = keep[3] * keep[1];
        colour = colour * kept + glm::dvec3(20, 30, 10) * (1 - kept);
        expectNear(frame.at(x, y), colour, "pixel " + std::to_string(x) + "," + std::to_string(y));
    }
}

TEST_P(TerrainGlTest, tiling_repeatsTheColourTextureFromTheNorthWest) {
    SceneBuilder scene;
    const std::uint32_t texture =
        scene.addTexture(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}, false);
    layout::TerrainCell cell = only(layer(texture));
    cell.base.tiling = 4.0f; // one texel per pixel
    const Frame frame = drawCell(scene, cell);
    EXPECT_EQ(frame.at(0, 0), glm::ivec3(255, 0, 0));
    EXPECT_EQ(frame.at(1, 0), glm::ivec3(0, 255, 0));
    EXPECT_EQ(frame.at(0, 1), glm::ivec3(0, 0, 255));
    EXPECT_EQ(frame.at(6, 2), glm::ivec3(255, 0, 0));
}

TEST_P(TerrainGlTest, landcellIsFoundByTheVerticesSurface) {
    SceneBuilder scene;
    scene.upload.terrainCells.push_back(only(layer(plain(scene, 255, 0, 0))));
    const Frame frame = drawCell(scene, only(layer(plain(scene, 0, 255, 0)))); // cell 1
    EXPECT_EQ(frame.at(3, 3), glm::ivec3(0, 255, 0));
    EXPECT_EQ(frame.picture()[3], "TTTTTTTT");
}

INSTANTIATE_TEST_SUITE_P(Ways, TerrainGlTest,
                         ::testing::Values(GroundWay{"exact"}, GroundWay{"fast", Drawing::Fast},
                                           GroundWay{"fastWithSeveralPages", Drawing::Fast, true}),
                         [](const auto& way) { return std::string(way.param.name); });

} // namespace
} // namespace limen::gpu::test
