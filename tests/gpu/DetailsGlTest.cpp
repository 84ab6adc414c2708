#include "GlFixture.h"

#include <cmath>

namespace limen::gpu::test {
namespace {

/// A wall of a cell, an exterior, a thing or ground, 2 m to 40 m north, under a detail picture of one texel.
class DetailsGlTest : public GlTest {
protected:
    static constexpr std::uint32_t kSize = 4;
    enum class Of { Shell, Exterior, Thing, Ground };

    static void setKind(SceneBuilder& scene, std::uint32_t kind) {
        for (layout::Instance& instance : scene.upload.instances)
            instance.membersAndKind = (instance.membersAndKind & layout::kMostMembers) | kind << 16;
    }
    static void addGround(SceneBuilder& scene, std::uint32_t texture, float y) {
        layout::TerrainCell cell;
        cell.base = {texture, layout::kNoTexture, 0, 1};
        for (layout::TerrainLayer& layer : cell.overlays)
            layer.texture = layout::kNoTexture;
        for (layout::TerrainLayer& layer : cell.roads)
            layer.texture = layout::kNoTexture;
        scene.upload.terrainCells.push_back(cell);
        scene.addWall('T', {-y, -y}, {y, y}, y, {.program = frame::Program::Terrain});
    }
    /// The three detail pictures differ: +0.2 red on shells, +0.2 blue on exteriors, half green over ground.
    static SceneBuilder under(Of of, float y, bool isOn = true) {
        SceneBuilder scene;
        scene.root(0);
        const std::uint32_t plain = scene.addTexture(1, 1, {100, 100, 100, 255}, false);
        const std::uint32_t shells = scene.addTexture(1, 1, {102, 51, 51, 51}, false);
        const std::uint32_t exteriors = scene.addTexture(1, 1, {51, 51, 102, 51}, false);
        const std::uint32_t land = scene.addTexture(1, 1, {0, 200, 0, 128}, false);
        scene.upload.details = {land, exteriors, shells};
        scene.plan.constants.detailTextures = {land, exteriors, shells, 0};
        scene.plan.constants.detailTiling = isOn ? glm::vec4(4, 4, 4, 0) : glm::vec4(0);
        if (of == Of::Ground) {
            addGround(scene, plain, y);
            setKind(scene, 1);
            return scene;
        }
        scene.addWall('A', {-y, -y}, {y, y}, y, {.material = scene.addMaterial({1, 1, 1, 1}, plain)});
        setKind(scene, of == Of::Shell      ? layout::kKindShell
                       : of == Of::Exterior ? layout::kKindExterior
                                            : 3u);
        return scene;
    }
    static std::vector<RendererOptions> allWays() {
        std::vector<RendererOptions> ways;
        for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
            for (const TextureMode mode : {TextureMode::Auto, TextureMode::ArrayPages}) {
                for (const bool byIndex : {true, false}) {
                    RendererOptions options{.drawing = drawing};
                    options.textures.mode = mode;
                    options.textures.pagesByIndex = byIndex;
                    ways.push_back(options);
                }
            }
        }
        return ways;
    }
    Frame drawn(SceneBuilder& scene, const RendererOptions& options, bool ids = false) {
        const frame::FramePlan& plan = scene.finish();
        Renderer renderer(*device_, options);
        const Result<void> uploaded = renderer.upload(scene.upload);
        EXPECT_TRUE(uploaded) << uploaded.error().message();
        Frame frame = renderWith(renderer, plan, kSize, kSize, {.wantIds = ids});
        calls_ = renderer.report().glCalls;
        return frame;
    }
    void expectColour(const glm::ivec3& colour, const glm::ivec3& expected, const std::string& what) {
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(colour[channel], expected[channel], 1) << what << " " << channel;
    }
    std::uint32_t calls_ = 0;
};

TEST_F(DetailsGlTest, addTheirColourMinusTheirAlphaToShellsAndExteriors_atAnyDistance) {
    int way = 0;
    for (const RendererOptions& options : allWays()) {
        for (const float y : {2.0f, 40.0f}) {
            const std::string what = std::to_string(way) + " " + std::to_string(y);
            SceneBuilder shell = under(Of::Shell, y), exterior = under(Of::Exterior, y);
            expectColour(drawn(shell, options).at(1, 1), {120, 100, 100}, "shell " + what);
            expectColour(drawn(exterior, options).at(1, 1), {100, 100, 120}, "exterior " + what);
        }
        SceneBuilder thing = under(Of::Thing, 2);
        expectColour(drawn(thing, options).at(1, 1), {100, 100, 100}, "thing " + std::to_string(way++));
    }
}

TEST_F(DetailsGlTest, coverTheGroundByTheirAlpha_fadingFrom10To50Metres) {
    for (const RendererOptions& options : allWays()) {
        for (const auto& [y, share] : {std::pair{2.0f, 1.0f}, {9.9f, 1.0f}, {30.0f, 0.5f}, {50.5f, 0.0f}}) {
            SceneBuilder ground = under(Of::Ground, y);
            const float alpha = share * 128.0f / 255.0f;
            const auto mixed = [&](float grain) { return std::lround(100 + (grain - 100) * alpha); };
            expectColour(drawn(ground, options).at(2, 1), {mixed(0), mixed(200), mixed(0)},
                         std::to_string(y));
        }
    }
}

TEST_F(DetailsGlTest, repeatByTheirTiling) {
    for (const RendererOptions& options : allWays()) {
        SceneBuilder scene;
        scene.root(0);
        const std::uint32_t plain = scene.addTexture(1, 1, {100, 100, 100, 255}, false);
        const std::uint32_t halves =
            scene.addTexture(2, 1, {255, 255, 255, 255, 127, 127, 127, 255}, false); // as it is, and half
        scene.upload.details.shells = halves;
        scene.plan.constants.detailTextures[2] = halves;
        scene.plan.constants.detailTiling[2] = 2;
        scene.addWall('A', {-2, -2}, {2, 2}, 2, {.material = scene.addMaterial({1, 1, 1, 1}, plain)});
        setKind(scene, layout::kKindShell);
        const Frame frame = drawn(scene, options); // four pixels: light, dark, light, dark
        for (std::uint32_t x = 0; x < kSize; ++x)
            EXPECT_NEAR(frame.at(x, 1).x, x % 2 == 0 ? 100 : 50, 1) << x;
    }
}

TEST_F(DetailsGlTest, changeNoIdsAndMakeNoCalls) {
    for (const RendererOptions& options : allWays()) {
        for (const Of of : {Of::Shell, Of::Exterior, Of::Ground}) {
            SceneBuilder with = under(of, 4), without = under(of, 4, false);
            const Frame shown = drawn(with, options, true);
            const std::uint32_t calls = calls_;
            const Frame plain = drawn(without, options, true);
            EXPECT_EQ(shown.ids, plain.ids);
            EXPECT_EQ(shown.depth, plain.depth);
            EXPECT_NE(shown.colour, plain.colour);
            EXPECT_EQ(calls, calls_);
        }
    }
}

/// A large wall with a lamp before its middle: its corners are far from it.
class PixelLampsGlTest : public GlTest {
protected:
    static SceneBuilder lampBeforeAWall(bool perPixel, frame::Program program,
                                        std::uint32_t kind = layout::kLitWalls) {
        SceneBuilder scene;
        scene.root(1);
        scene.plan.constants.skyAmbient = {0.1f, 0.1f, 0.1f, 0};
        scene.plan.constants.flags = perPixel ? layout::kFramePixelLamps : 0;
        scene.upload.lightSets.push_back({kind, 0, 1, 0});
        scene.plan.lamps = {{{0, 3, 0, 3}, {glm::vec3(1, 0.5f, 0), 1.0f}}};
        scene.upload.lamps = 1;
        scene.upload.lampRefs = {0};
        const std::uint32_t picture = scene.addTexture(1, 1, {255, 255, 255, 255}, false);
        const std::uint32_t flags = program == frame::Program::Blended ? layout::kMaterialAlpha : 0;
        scene.addWall('A', {-4, -4}, {4, 4}, 4,
                      {.members = {{1, 1}},
                       .material = scene.addMaterial({1, 1, 1, 1}, picture, flags),
                       .program = program});
        return scene;
    }
};

TEST_F(PixelLampsGlTest, lightWallsByTheFormulaOfVertices) {
    for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
        for (const frame::Program program :
             {frame::Program::Opaque, frame::Program::CutOut, frame::Program::Blended}) {
            SceneBuilder perPixel = lampBeforeAWall(true, program),
                         perVertex = lampBeforeAWall(false, program);
            Renderer first(*device_, {.drawing = drawing});
            ASSERT_TRUE(first.upload(perPixel.upload));
            const Frame lit = renderWith(first, perPixel.finish(), 9, 9, {.wantIds = false});
            const Frame corners = renderWith(first, perVertex.finish(), 9, 9, {.wantIds = false});
            // In the middle, 1 m away: (1/2 + 1) / 1.5 * (1 - 1 / 3.9) of the lamp's colour.
            EXPECT_NEAR(lit.at(4, 4).x, 255 * (0.1 + 1.0 - 1.0 / 3.9), 2);
            EXPECT_NEAR(lit.at(4, 4).y, 255 * (0.1 + 0.5 * (1.0 - 1.0 / 3.9)), 2);
            EXPECT_NEAR(lit.at(4, 4).z, 25.5, 0.5);
            EXPECT_NEAR(corners.at(4, 4).x, 26, 1) << "the corners are out of reach";
        }
    }
}

TEST_F(PixelLampsGlTest, leaveOtherObjectsAndIdsAsTheyAre) {
    for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
        SceneBuilder perPixel = lampBeforeAWall(true, frame::Program::Opaque, layout::kLitThing);
        SceneBuilder perVertex = lampBeforeAWall(false, frame::Program::Opaque, layout::kLitThing);
        Renderer renderer(*device_, {.drawing = drawing});
        ASSERT_TRUE(renderer.upload(perPixel.upload));
        const Frame lit = renderWith(renderer, perPixel.finish(), 9, 9, {.wantIds = true});
        const Frame corners = renderWith(renderer, perVertex.finish(), 9, 9, {.wantIds = true});
        EXPECT_EQ(lit.colour, corners.colour);
        EXPECT_EQ(lit.ids, corners.ids);
        EXPECT_EQ(lit.depth, corners.depth);
    }
}

} // namespace
} // namespace limen::gpu::test
