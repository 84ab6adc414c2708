#include "GlFixture.h"

#include <algorithm>
#include <random>

namespace limen::gpu::test {
namespace {

class DrawCullingGlTest : public GlTest {
protected:
    // Draws the scene with and without culling and compares all images.
    void expectSame(SceneBuilder& scene, std::uint32_t size, const RenderOptions& options = {}) {
        Renderer all(*device_, {.culling = Culling::None});
        Renderer culled(*device_);
        ASSERT_TRUE(all.upload(scene.upload));
        ASSERT_TRUE(culled.upload(scene.upload));
        const frame::FramePlan& plan = scene.finish(true);
        const Frame whole = renderWith(all, plan, size, size, options);
        const Frame less = renderWith(culled, plan, size, size, options);
        EXPECT_EQ(whole.ids, less.ids);
        EXPECT_EQ(whole.depth, less.depth);
        const bool writesColour = options.shading != Shading::IdsOnly;
        EXPECT_TRUE(!writesColour || whole.colour == less.colour);
        EXPECT_EQ(whole.layers, less.layers);
        seen_ = static_cast<std::size_t>(
            std::count_if(whole.ids.begin(), whole.ids.end(), [](std::uint32_t id) { return id >= 100; }));
    }

    std::size_t seen_ = 0; ///< pixels that show a quad
};

constexpr std::array<frame::Program, 3> kPrograms{frame::Program::Opaque, frame::Program::CutOut,
                                                  frame::Program::Blended};

// Quads from a fraction of a pixel to far larger, in any orientation, some across the eye's plane, some
// mirrored.
SceneBuilder anyQuads(std::uint32_t seed, std::uint32_t count) {
    SceneBuilder scene;
    scene.root(0);
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 middle(between(-4, 4), between(-1, 6), between(-4, 4));
        const float size = std::exp(between(-6.0f, 1.5f));
        const glm::vec3 right = size * glm::vec3(between(-1, 1), between(-1, 1), between(-1, 1));
        const glm::vec3 up = size * glm::vec3(between(-1, 1), between(-1, 1), between(-1, 1));
        QuadOptions options{.program = kPrograms[i % 3], .gated = i % 5 == 0};
        if (i % 7 == 0)
            options.rows[0] = {-1, 0, 0, 0};
        scene.addQuad(100 + i,
                      {middle - right - up, middle + right - up, middle + right + up, middle - right + up},
                      options);
    }
    return scene;
}

TEST_F(DrawCullingGlTest, changesNoPicture) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        SceneBuilder scene = anyQuads(seed, 400);
        for (const std::uint32_t size : {7u, 32u, 131u}) {
            expectSame(scene, size);
            EXPECT_GT(seen_, 0u);
            expectSame(scene, size, {.shading = Shading::IdsOnly});
            expectSame(scene, size, {.wantLayers = true});
        }
    }
}

// Triangles that the driver received in a frame.
std::uint32_t trianglesGiven(Renderer& renderer, const frame::FramePlan& plan, RenderTarget& target) {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    EXPECT_TRUE(renderer.render(plan, target));
    glEndQuery(GL_PRIMITIVES_GENERATED);
    GLuint given = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &given);
    glDeleteQueries(1, &query);
    return given;
}

// Rectangles like those of visits. Triangles that overlap one are kept, others are culled, also triangles
// that extend behind the eye.
TEST_F(DrawCullingGlTest, trianglesOutsideTheRunsRectanglesAreCulled_andNoOthers) {
    constexpr std::uint32_t kSize = 128; // an eighth of NDC is a whole number of pixels
    constexpr float kHalf = kSize / 2;
    const std::array<glm::vec4, 2> rects{glm::vec4{-0.75f, -0.5f, -0.25f, 0.5f},
                                         {0.125f, -0.875f, 0.5f, 0.25f}};
    std::size_t inside = 0, gone = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        SceneBuilder scene = anyQuads(seed, 300);
        Renderer renderer(*device_);
        ASSERT_TRUE(renderer.upload(scene.upload));
        frame::FramePlan plan = scene.finish(true);
        const Frame whole = renderWith(renderer, plan, kSize, kSize);
        plan.rects.assign(rects.begin(), rects.end());
        for (frame::PieceRun& run : plan.runs)
            run.rects = {0, static_cast<std::uint16_t>(rects.size())};
        const Frame less = renderWith(renderer, plan, kSize, kSize);
        for (std::uint32_t y = 0; y < kSize; ++y) {
            for (std::uint32_t x = 0; x < kSize; ++x) {
                const glm::vec2 ndc((static_cast<float>(x) + 0.5f) / kHalf - 1.0f,
                                    1.0f - (static_cast<float>(y) + 0.5f) / kHalf);
                const bool isIn = std::any_of(rects.begin(), rects.end(), [&](const glm::vec4& rect) {
                    return ndc.x > rect.x && ndc.x < rect.z && ndc.y > rect.y && ndc.y < rect.w;
                });
                const std::size_t pixel = std::size_t{y} * kSize + x;
                const bool isSame = whole.ids[pixel] == less.ids[pixel] && whole.at(x, y) == less.at(x, y);
                ASSERT_TRUE(isSame || !isIn) << seed << ": " << x << ", " << y;
                inside += isIn && whole.ids[pixel] >= 100 ? 1 : 0;
                gone += isSame ? 0 : 1;
            }
        }
    }
    EXPECT_GT(inside, 2000u);
    EXPECT_GT(gone, 500u) << "the rectangles have an effect";
}

TEST_F(DrawCullingGlTest, trianglesBehindGroundAreCulled_andNoOthers) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        SceneBuilder scene = anyQuads(seed, 400);
        scene.upload.terrainCells.resize(1);
        frame::gpu::TerrainCell& cell = scene.upload.terrainCells[0];
        cell.base = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
        for (layout::TerrainLayer* layer : {cell.overlays, cell.roads})
            layer[0].texture = layer[1].texture = layout::kNoTexture;
        cell.overlays[2].texture = layout::kNoTexture;
        for (int step = -4; step < 4; ++step) {
            const auto x = static_cast<float>(step);
            scene.addWall(90, {x, -4}, {x + 1.01f, 0.7f * x}, 2.0f + 0.5f * x,
                          {.program = frame::Program::Terrain});
        }
        for (const std::uint32_t size : {7u, 32u, 131u}) {
            expectSame(scene, size);
            expectSame(scene, size, {.wantLayers = true});
        }
        const frame::FramePlan& plan = scene.finish(true);
        Renderer all(*device_, {.culling = Culling::Unseen}), less(*device_);
        ASSERT_TRUE(all.upload(scene.upload) && less.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(*device_, 131, 131);
        EXPECT_LT(trianglesGiven(less, plan, *target) + 10, trianglesGiven(all, plan, *target));
    }
}

// Two walls, one behind the other. The second shows above the first, by as little as one row of pixels.
TEST_F(DrawCullingGlTest, trianglesVisibleByOnePixelAreKept) {
    constexpr std::uint32_t kSize = 64;
    for (const float pixels : {0.0f, 0.9f, 1.1f, 7.9f, 8.1f, 17.0f}) {
        SceneBuilder scene;
        scene.root(0);
        scene.addWall(100, {-2, -2}, {2, 1 - 2 * pixels / kSize}, 1, {.program = frame::Program::Opaque});
        scene.addWall(101, {-4, -4}, {4, 4}, 2, {.program = frame::Program::CutOut});
        frame::FramePlan plan = scene.finish(true);
        plan.firstOccludee = 3; // ownership, ground, opaque
        Renderer renderer(*device_);
        ASSERT_TRUE(renderer.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(*device_, kSize, kSize);
        const std::uint32_t given = trianglesGiven(renderer, plan, *target);
        const std::vector<std::uint32_t> ids = target->readIds();
        EXPECT_EQ(std::count(ids.begin(), ids.end(), 101u), std::lround(pixels) * kSize) << pixels;
        EXPECT_EQ(std::count(ids.begin(), ids.end(), 100u), kSize * kSize - std::lround(pixels) * kSize);
        EXPECT_EQ(given, pixels > 0.0f ? 5u : 3u) << pixels; // two of each wall, and the sky's
    }
}

// The triangle's rectangle on the screen just contains a pixel's centre, or just misses it.
TEST_F(DrawCullingGlTest, aTriangleOnASinglePixelsCentreIsKept) {
    constexpr std::uint32_t kSize = 8;
    constexpr float kPixel = 2.0f / kSize; // metres at a distance of 1 m
    for (const float half : {0.02f * kPixel, 0.2f * kPixel, 0.4f * kPixel}) {
        for (const float off : {0.0f, 0.9f, 1.1f}) {
            SceneBuilder scene;
            scene.root(0);
            const glm::vec2 centre = glm::vec2(0.5f * kPixel + off * half, 0.5f * kPixel);
            scene.addWall(100, centre - half, centre + half, 1);
            expectSame(scene, kSize);
            EXPECT_EQ(seen_, off < 1.0f ? 1u : 0u);
        }
    }
}

// At equal depth the later triangle of a mesh wins.
TEST_F(DrawCullingGlTest, keepsTheOrderOfTriangles) {
    SceneBuilder scene;
    scene.root(0);
    std::vector<std::array<glm::vec3, 4>> quads;
    for (std::uint32_t i = 0; i < layout::kTrianglesPerPiece / 2; ++i) {
        const float half =
            i % 3 == 0 ? 0.001f : 1.0f - 0.001f * static_cast<float>(i); // some cover no centre
        quads.push_back({glm::vec3{-half, 1, -half}, {half, 1, -half}, {half, 1, half}, {-half, 1, half}});
    }
    scene.addQuads(100, quads);
    expectSame(scene, 16);
    EXPECT_EQ(seen_, 256u);
}

// More draws than work groups in a row.
TEST_F(DrawCullingGlTest, manyDraws) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall(100, {-0.001f, -0.001f}, {0.001f, 0.001f}, 1); // covers no centre
    scene.addWall(101, {-1, -1}, {1, 1}, 1);
    for (std::uint32_t i = 2; i < kMostGroups + 10; ++i)
        scene.drawAgain(i % 2, frame::Program::Opaque, false);
    expectSame(scene, 4);
    EXPECT_EQ(seen_, 16u);
}

// Pieces of the frame, such as those of dynamic instances, are drawn like resident ones.
TEST_F(DrawCullingGlTest, aPlansOwnPiecesShowTheSame) {
    SceneBuilder scene = anyQuads(3, 300);
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    frame::FramePlan plan = scene.finish(true);
    const Frame resident = renderWith(renderer, plan, 64, 64, {.wantLayers = true});
    plan.pieces = scene.upload.pieces; // there is no sky
    for (frame::PieceRun& run : plan.runs)
        run.firstPiece += plan.constants.staticPieces;
    const Frame own = renderWith(renderer, plan, 64, 64, {.wantLayers = true});
    EXPECT_GT(std::count_if(own.ids.begin(), own.ids.end(), [](std::uint32_t id) { return id >= 100; }), 500);
    EXPECT_EQ(resident.ids, own.ids);
    EXPECT_EQ(resident.depth, own.depth);
    EXPECT_EQ(resident.layers, own.layers);
}

TEST_F(DrawCullingGlTest, manyTrianglesInManyFrames) {
    Renderer renderer(*device_);
    for (const std::uint32_t count : {10u, 30'000u, 100u}) {
        SceneBuilder scene;
        scene.root(0);
        for (std::uint32_t i = 0; i < count; ++i)
            scene.addWall(100 + i, {-9, -9}, {9, 9}, 1.0f + 0.001f * static_cast<float>(i));
        ASSERT_TRUE(renderer.upload(scene.upload));
        const frame::FramePlan& plan = scene.finish();
        for (int frame = 0; frame < 4; ++frame) // more than are in flight at once
            EXPECT_EQ(renderWith(renderer, plan, 4, 4).ids, std::vector<std::uint32_t>(16, 100));
    }
}

} // namespace
} // namespace limen::gpu::test
