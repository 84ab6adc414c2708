#include "GlFixture.h"
#include "geometry/Tolerances.h"
#include "gpu/device/NullDevice.h"

#include <cstring>
#include <map>
#include <set>

namespace limen::gpu::test {
namespace {

constexpr std::uint32_t kMostFastCalls = 40; // GL calls per frame

/// The fast way of drawing, against the exact one.
class FastGlTest : public GlTest {
protected:
    static RendererOptions fast() { return {.drawing = Drawing::Fast}; }
    /// Draws one scene both ways.
    struct Both {
        Frame exact, fast;
    };
    Both drawBoth(SceneBuilder& scene, std::uint32_t size, const RenderOptions& options = {},
                  RendererOptions renderer = fast()) {
        const frame::FramePlan& plan = scene.finish();
        Renderer exactly(*device_), fastly(*device_, std::move(renderer));
        for (Renderer* each : {&exactly, &fastly}) {
            const Result<void> uploaded = each->upload(scene.upload);
            EXPECT_TRUE(uploaded) << uploaded.error().message();
        }
        return {renderWith(exactly, plan, size, size, options),
                renderWith(fastly, plan, size, size, options)};
    }
    /// The numbers of GL calls of four frames. Expects that they are within the budget, and the same on a null device.
    std::set<std::uint32_t> countCalls(const frame::SceneUpload& scene, const frame::FramePlan& plan,
                                       const RenderOptions& options) {
        NullDevice null(device_->capabilities());
        Renderer real(*device_, fast()), recorded(null, fast());
        EXPECT_TRUE(real.upload(scene));
        EXPECT_TRUE(recorded.upload(scene));
        Result<RenderTarget> target = RenderTarget::create(*device_, 8, 8, {.wide = true}),
                             nullTarget = RenderTarget::create(null, 8, 8, {.wide = true});
        std::set<std::uint32_t> counts;
        for (int i = 0; i < 4; ++i) {
            EXPECT_TRUE(real.render(plan, *target, options));
            EXPECT_TRUE(recorded.render(plan, *nullTarget, options));
            EXPECT_EQ(real.report().glCalls, recorded.report().glCalls);
            EXPECT_LE(real.report().glCalls, kMostFastCalls);
            counts.insert(real.report().glCalls);
        }
        return counts;
    }
    /// The greatest difference of a channel.
    static int difference(const Frame& a, const Frame& b) {
        int most = 0;
        for (std::size_t i = 0; i < a.colour.size(); ++i)
            most = std::max(most, std::abs(int{a.colour[i]} - int{b.colour[i]}));
        return most;
    }
    static std::uint32_t checkered(SceneBuilder& scene, std::uint8_t alpha = 255) {
        return scene.addTexture(2, 2, {250, 0, 0, 255, 0, 250, 0, alpha, 0, 0, 250, alpha, 90, 80, 70, 255},
                                false);
    }
    /// A room with an opening into another, a thing in each, and the outside beyond a second opening.
    static SceneBuilder rooms() {
        SceneBuilder scene;
        const std::uint32_t picture = scene.addMaterial({1, 1, 1, 1}, checkered(scene));
        const std::uint32_t cut = scene.addMaterial({1, 1, 1, 1}, checkered(scene, 0));
        const std::uint32_t glass =
            scene.addMaterial({0.5f, 0.6f, 0.7f, 0.5f}, layout::kNoTexture, layout::kMaterialAlpha);
        scene.root(1);
        const std::uint32_t next = scene.visitThrough({-1, -1}, {1, 1}, 2, 2, 0);
        scene.visitThrough({-0.5f, -0.5f}, {0.5f, 0.5f}, 4, 0, next);
        scene.addWallWithOpening('A', 4, 1, 2, {.members = {{1, 0}}, .material = picture});
        scene.addWallWithOpening('B', 8, 0.5f, 4, {.members = {{2, 0}}, .material = picture, .gated = true});
        scene.addWall('h', {-9, -9}, {9, 9}, 3,
                      {.members = {{3, 0}}, .gated = true}); // hidden: of no visit's zone
        scene.addWall(
            'c', {-1, -1}, {0, 1}, 3,
            {.members = {{2, 0}}, .material = cut, .program = frame::Program::CutOut, .gated = true});
        scene.addWall(
            'g', {-4, -4}, {4, 0}, 1.5f,
            {.members = {{1, 0}}, .material = glass, .program = frame::Program::Blended, .gated = true});
        scene.addSky({-3, -3}, {3, 3}, 1, glass, 0.5f);
        return scene;
    }
};

TEST_F(FastGlTest, showsTheSameSurfaces_depthAndOwners) {
    SceneBuilder scene = rooms();
    const Both both = drawBoth(scene, 32);
    EXPECT_EQ(both.fast.picture(), both.exact.picture());
    EXPECT_EQ(both.fast.ownership, both.exact.ownership);
    EXPECT_EQ(std::set<std::uint32_t>(both.fast.ids.begin(), both.fast.ids.end()).count('h'), 0u);
    for (std::size_t i = 0; i < both.exact.depth.size(); ++i)
        if (both.exact.ids[i] != layout::kSkyId) // a fast sky writes no depth
            EXPECT_NEAR(both.fast.depth[i], both.exact.depth[i], 1e-5f * both.exact.depth[i]) << i;
}

/// An opening of a root whose surfaces are in front of it, behind it, through it and in its plane, and a room behind it.
SceneBuilder doorway(bool isShut) {
    using frame::Turn;
    SceneBuilder scene;
    const std::uint32_t cut =
        scene.addMaterial({1, 1, 1, 1}, scene.addTexture(2, 1, {9, 9, 9, 255, 9, 9, 9, 0}, false));
    const auto ofRoot = [](bool gated = true, Turn turn = Turn::Before) {
        return QuadOptions{.members = {{1, 0}}, .gated = gated, .turn = turn};
    };
    scene.root(1);
    scene.visitThrough({-1, -1}, {1, 1}, 2, 2, 0);
    scene.plan.visits[1].shutBy = isShut ? 'F' : 0;
    scene.addWallWithOpening('A', 4, 1, 2, ofRoot(false));
    scene.addWall('f', {-0.9f, -0.9f}, {-0.5f, 0.5f}, 1.8f, ofRoot());
    scene.addQuad('t', {{{-0.4f, 1, -0.5f}, {0.4f, 4, -0.5f}, {0.4f, 4, 0.1f}, {-0.4f, 1, 0.1f}}},
                  ofRoot()); // through it
    scene.addWall('b', {-4, -4}, {0, 4}, 2.5f, ofRoot());
    scene.addWall('p', {0.2f, 0.2f}, {0.6f, 0.9f}, 2, ofRoot()); // in its plane
    scene.addWall('m', {-0.2f, 0.2f}, {0.1f, 2}, 1.5f,
                  {.members = {{1, 0}},
                   .material = cut,
                   .program = frame::Program::CutOut,
                   .gated = true,
                   .turn = Turn::Before});
    if (isShut)
        scene.addWall('F', {-1, -1}, {1, 1}, 2, ofRoot(true, Turn::After));
    scene.addWall('R', {-3, -3}, {3, 3}, 3, {.members = {{2, 0}}, .turn = Turn::After});
    scene.addWall('s', {-9, -9}, {9, -0.6f}, 2.8f,
                  {.members = {{1, 0}, {2, 0}}, .gated = true, .turn = Turn::Both});
    scene.addWall('c', {0, -0.5f}, {1, 0.5f}, 2.2f,
                  {.members = {{2, 0}}, .material = cut, .program = frame::Program::CutOut, .gated = true});
    return scene;
}

// Decision 216.
TEST_F(FastGlTest, showsTheSameSurfaces_rootFirst) {
    for (const bool isShut : {false, true}) {
        SceneBuilder scene = doorway(isShut);
        const Both tested = drawBoth(scene, 64);
        EXPECT_EQ(tested.fast.picture(), tested.exact.picture());
        const frame::FramePlan& plan = scene.finishRootFirst();
        Renderer renderer(*device_, fast());
        ASSERT_TRUE(renderer.upload(scene.upload));
        const Frame cleared = renderWith(renderer, plan, 64, 64);
        EXPECT_EQ(cleared.picture(), tested.fast.picture()) << isShut;
        const Frame colours = renderWith(renderer, plan, 64, 64, {.wantIds = false});
        EXPECT_EQ(colours.colour, cleared.colour);
        const std::set<std::uint32_t> shown(cleared.ids.begin(), cleared.ids.end());
        EXPECT_EQ(shown.count('F'), isShut ? 1u : 0u);
        EXPECT_EQ(shown.count('p'), isShut ? 0u : 1u)
            << "a surface in the plane of a shut opening is behind its filling";
        EXPECT_EQ(shown.count('R'), isShut ? 0u : 1u);
        for (const char front : {'A', 'f', 't', 'm'})
            EXPECT_EQ(shown.count(static_cast<std::uint32_t>(front)), 1u) << front;
    }
}

// They are drawn once, after the clearing, for the root and for other visits. The plan has no test for those of the root alone.
TEST_F(FastGlTest, cutOutsOfTheRootThatLampsLightTakeTheTest_rootFirst) {
    const auto withLitCutOut = [](bool gated) {
        SceneBuilder scene = doorway(false);
        const std::uint32_t cut =
            scene.addMaterial({1, 1, 1, 1}, scene.addTexture(2, 1, {9, 9, 9, 255, 9, 9, 9, 0}, false));
        scene.plan.lamps = {{{0, 1, 0, 6}, {0.5f, 0.4f, 0.3f, 0.7f}}};
        scene.upload.lamps = 1;
        scene.upload.lampRefs = {0};
        layout::LightSet lit = scene.upload.lightSets[0];
        lit.lampCount = 1;
        scene.upload.lightSets.push_back(lit);
        const auto set = static_cast<std::uint32_t>(scene.upload.lightSets.size() - 1);
        scene.addWall('l', {-0.4f, 0.3f}, {1.6f, 0.7f}, 2.1f,
                      {.members = {{1, set}},
                       .material = cut,
                       .program = frame::Program::CutOut,
                       .gated = gated,
                       .turn = frame::Turn::Before});
        scene.addWall('L', {0.5f, -0.9f}, {0.9f, -0.6f}, 1.5f,
                      {.members = {{1, set}},
                       .material = cut,
                       .program = frame::Program::CutOut,
                       .gated = gated,
                       .turn = frame::Turn::Before});
        return scene;
    };
    SceneBuilder gated = withLitCutOut(true), ungated = withLitCutOut(false);
    const Both tested = drawBoth(gated, 64);
    const frame::FramePlan& plan = ungated.finishRootFirst();
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(ungated.upload));
    const Frame cleared = renderWith(renderer, plan, 64, 64);
    EXPECT_EQ(cleared.picture(), tested.exact.picture());
    EXPECT_NE(std::count(cleared.ids.begin(), cleared.ids.end(), std::uint32_t{'L'}), 0)
        << "before the opening";
}

TEST_F(FastGlTest, showsTheSameSamples_rootFirst) {
    for (const bool isShut : {false, true}) {
        SceneBuilder scene = doorway(isShut);
        Renderer renderer(*device_, fast());
        ASSERT_TRUE(renderer.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(*device_, 64, 64, {.samples = layout::kSamples});
        ASSERT_TRUE(target);
        const auto draw = [&](const frame::FramePlan& plan) {
            EXPECT_TRUE(renderer.render(plan, *target, {.wantIds = false, .shading = Shading::FlatIds}));
            return target->readColour();
        };
        const std::vector<std::uint8_t> tested = draw(scene.finish());
        EXPECT_EQ(draw(scene.finishRootFirst()), tested) << isShut;
        const std::set<std::uint8_t> shades(tested.begin(), tested.end());
        EXPECT_GT(shades.size(), 20u) << "means of several surfaces";
    }
}

TEST_F(FastGlTest, rootFirstStaysWithinTheBudgetOfCalls_andNullDeviceCountsThemAlike) {
    SceneBuilder scene = doorway(false);
    scene.upload.terrainCells.resize(1);
    scene.upload.terrainCells[0].base = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
    scene.plan.constants.voidColour = StateTracker::kFirstClearColour;
    const frame::FramePlan& plan = scene.finishRootFirst();
    for (const bool wantIds : {false, true})
        EXPECT_EQ(countCalls(scene.upload, plan, {.wantIds = wantIds}).size(), 1u)
            << "first and later frames";
}

/// Openings side by side that fill the picture, each into a zone of its own, with a picture of that zone, and one that
/// belongs to it and to the zone after it.
SceneBuilder row(std::uint32_t openings) {
    SceneBuilder scene;
    scene.root(1);
    const float wide = 8.0f / static_cast<float>(openings);
    for (std::uint32_t i = 0; i < openings; ++i) {
        const float left = -4.0f + wide * static_cast<float>(i);
        scene.visitThrough({left, -4}, {left + wide, 4}, 4, 2 + i, 0);
    }
    for (std::uint32_t i = 0; i < openings; ++i) {
        scene.addWall(1000 + i, {-9, 0}, {9, 9}, 5, {.members = {{2 + i, 0}}, .gated = true});
        scene.addWall(2000 + i, {-9, -9}, {9, 0}, 5 + 0.01f * static_cast<float>(i % 2),
                      {.members = {{2 + i, 0}, {3 + i, 0}}, .gated = true});
    }
    return scene;
}

// Up to frame::gpu::kMostVisitBits visits have a bit each in the records of draws; more have lists of members.
TEST_F(FastGlTest, showsTheSameSurfacesForAnyNumberOfVisits) {
    for (const std::uint32_t visits : {2u, 33u, layout::kMostVisitBits, layout::kMostVisitBits + 1, 100u}) {
        SceneBuilder scene = row(visits - 1);
        const Both both = drawBoth(scene, 256);
        EXPECT_EQ(both.fast.ids, both.exact.ids) << visits;
        const std::set<std::uint32_t> shown(both.exact.ids.begin(), both.exact.ids.end());
        EXPECT_GE(shown.size(), 1.5 * (visits - 1)) << "every opening shows its own zone";
    }
}

TEST_F(FastGlTest, openingsOwnTheSamePixelsWithinAClipSet) {
    layout::ClipSet left, nothing;
    std::fill(std::begin(left.planes), std::end(left.planes), layout::vec4(0, 0, 0, 1));
    left.planes[0] = {-1, 0.1f, 0, 0}; // x <= y / 10
    nothing = left;
    nothing.planes[layout::kLastClipPlane] = {0, 1, 0, -9}; // y >= 9: behind the openings
    for (const layout::ClipSet& set : {left, nothing}) {
        SceneBuilder scene = rooms();
        scene.plan.clipSets.push_back(set);
        for (layout::OwnershipVertex& vertex : scene.plan.ownershipVertices) {
            vertex.clipSet = 1;
            vertex.clipEdges = 1;
        }
        const Both both = drawBoth(scene, 32);
        EXPECT_EQ(both.fast.ownership, both.exact.ownership);
        const auto owned =
            both.fast.ownership.size() -
            static_cast<std::size_t>(std::count(both.fast.ownership.begin(), both.fast.ownership.end(), 0u));
        EXPECT_EQ(owned > 0, set.planes[layout::kLastClipPlane].w > 0.0f);
    }
}

TEST_F(FastGlTest, aRegionOnTheScreenOwnsItsPixels) {
    SceneBuilder scene = rooms();
    auto& vertices = scene.plan.ownershipVertices;
    vertices.resize(3); // the left half of the window, with two corners far beyond it
    const std::array<Vec3f, 3> corners{Vec3f(0, -3, 1), Vec3f(0, 3, 1), Vec3f(-8, 0, 2)};
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {corners[i], 0, 1, 0, 0, layout::kOnScreen, Vec3f(0.0f), 1};
    const Frame drawn = render(scene, 32, fast());
    for (std::size_t i = 0; i < drawn.ownership.size(); ++i)
        EXPECT_EQ(drawn.ownership[i] != 0, i % 32 < 16) << i;
}

TEST_F(FastGlTest, showsTheSameColours) {
    SceneBuilder scene = rooms();
    for (const bool ids : {true, false}) {
        const Both both = drawBoth(scene, 32, {.wantIds = ids});
        EXPECT_LE(difference(both.exact, both.fast), 2);
    }
}

TEST_F(FastGlTest, sharedVerticesShowTheSameAsEachTrianglesOwn) {
    SceneBuilder scene = rooms();
    const frame::FramePlan& plan = scene.finish();
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    const Frame own = renderWith(renderer, plan, 48, 48, {.wantIds = true});
    const Frame shared = renderWith(renderer, plan, 48, 48, {.wantIds = false});
    EXPECT_EQ(own.colour, shared.colour);
}

TEST_F(FastGlTest, aCrackTakesTheColourOfItsNeighbour_aHoleStays) {
    constexpr std::uint32_t kSize = 32;
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-0.1f, -0.1f}, {0.1f, 0.1f}, 2, 2, 0); // several visits, none outside
    scene.addWall('l', {-9, -9}, {-1.155f, 9}, 4, {.members = {{1, 0}}});
    scene.addWall('r', {-1.095f, -9}, {1, 9}, 4, {.members = {{1, 0}}}); // a crack, then a hole to its right
    const Both both = drawBoth(scene, kSize, {.wantIds = true});
    const auto voids = [](const Frame& frame) {
        return std::count(frame.ids.begin(), frame.ids.end(), layout::kVoidId);
    };
    const auto wide = voids(both.exact) - 2 * kSize; // but the crack and the pixels beside the wall
    EXPECT_EQ(voids(both.fast), wide);
    EXPECT_GT(wide, 4 * kSize) << "a hole is not hidden";
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    const Frame withoutIds = renderWith(renderer, scene.finish(), kSize, kSize, {.wantIds = false});
    EXPECT_EQ(withoutIds.colour, both.fast.colour);
}

// As from outside: a house's room is seen through its door, and voids are sought there alone (frame/OpeningCells.h).
TEST_F(FastGlTest, voidsInRectanglesAreThoseOfTheWholePicture) {
    SceneBuilder scene;
    scene.root(layout::kOutside);
    scene.visitThrough({-0.4f, -0.4f}, {0.4f, 0.4f}, 2, 2, 0);
    scene.addWallWithOpening('A', 1, 0.4f, 2, {.members = {{layout::kOutside, 0}}});
    const frame::FramePlan& plan = scene.finish();
    frame::FramePlan split = plan;
    const auto sky = std::find_if(split.batches.begin(), split.batches.end(), [](const frame::Batch& batch) {
        return batch.program == frame::Program::SkyPlain;
    });
    ASSERT_NE(sky, split.batches.end());
    split.rects = {{-0.25f, -0.25f, 0.25f, 0.0f}, {-0.25f, 0.0f, 0.25f, 0.25f}};
    *sky = {frame::Program::SkyPlain, true, 0, 2, 1};
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    for (const std::uint32_t size : {37u, 64u}) {
        const Frame whole = renderWith(renderer, plan, size, size, {.wantIds = true}),
                    parts = renderWith(renderer, split, size, size, {.wantIds = true});
        EXPECT_EQ(whole.ids, parts.ids);
        EXPECT_LE(difference(whole, parts), 1);
        const auto count = [&](std::uint32_t id) {
            return std::count(whole.ids.begin(), whole.ids.end(), id);
        };
        EXPECT_GT(count(layout::kSkyId), 0);
        EXPECT_GT(count(layout::kVoidId), 0) << "the room has no walls";
    }
}

TEST_F(FastGlTest, countsTheSameLayers) {
    SceneBuilder scene = rooms();
    const Both both = drawBoth(scene, 32, {.wantLayers = true});
    EXPECT_EQ(both.exact.layers, both.fast.layers);
    EXPECT_GT(std::count_if(both.fast.layers.begin(), both.fast.layers.end(),
                            [](const LayerSum& sum) { return sum.count > 0; }),
              0);
}

// Decision 221. Corners of clipped triangles are other ones, but this scene has none at the picture's border.
TEST_F(FastGlTest, aWideViewportShowsTheSame_andTooLargeOnesAreNotWide) {
    SceneBuilder scene = rooms();
    const frame::FramePlan& plan = scene.finish();
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    std::vector<std::vector<std::uint8_t>> colours;
    std::vector<std::vector<std::uint32_t>> ids;
    for (const bool wide : {false, true}) {
        for (const std::uint32_t size : {33u, 64u}) {
            Result<RenderTarget> target = RenderTarget::create(*device_, size, size, {.wide = wide});
            ASSERT_TRUE(target);
            ASSERT_TRUE(renderer.render(plan, *target, {}));
            colours.push_back(target->readColour());
            ids.push_back(target->readIds());
        }
    }
    for (const std::size_t i : {0u, 1u}) {
        EXPECT_EQ(colours[i], colours[i + 2]);
        EXPECT_EQ(ids[i], ids[i + 2]);
    }
    const Viewport picture{-3, 0, 640, 360}, doubled{-323, -180, 1280, 720};
    EXPECT_EQ(picture.doubled(1280), doubled);
    EXPECT_EQ(picture.doubled(1279).width, 640u) << "too large";
    EXPECT_EQ((Viewport{0, 0, 33, 20}.doubled(4096)), (Viewport{0, -10, 33, 40}))
        << "an odd side has no middle";
}

/// An upright rectangle in a plane through the eye's place moved by `height` metres, `turn` degrees from north. `min`, `max`: metres along the
/// plane and upwards.
std::array<glm::vec3, 4> uprightAtTheEye(float turn, float height, glm::vec2 min, glm::vec2 max) {
    const float along = glm::radians(turn);
    const auto corner = [&](float metres, float z) {
        return glm::vec3{metres * std::sin(along) + height * std::cos(along),
                         metres * std::cos(along) - height * std::sin(along), z};
    };
    return {corner(max.x, min.y), corner(min.x, min.y), corner(min.x, max.y), corner(max.x, max.y)};
}

/// Adds a rectangle that is seen from both sides: two instances.
void addBothSides(SceneBuilder& scene, std::uint32_t id, const std::array<glm::vec3, 4>& front,
                  const QuadOptions& options) {
    scene.addQuad(id, front, options);
    scene.addQuad(id, {front[3], front[2], front[1], front[0]}, options);
}

// The eye is micrometres before a wall that reaches far to both sides. In a viewport of the picture's size, columns at its border are void.
TEST_F(FastGlTest, aWallAtTheEyeReachesTheBorders) {
    std::int64_t walls = 0;
    for (const float turn : {-34.0f, -7.0f, 3.0f, 11.0f, 20.0f, 27.0f, 31.0f}) {
        for (const float height : {1e-6f, 1.5e-6f, 2e-6f, 3e-6f}) {
            SceneBuilder scene;
            scene.plan.constants.nearPlane = scene.plan.constants.clipFromEye[3][2] =
                static_cast<float>(kDefaultNearPlane);
            scene.root(1);
            scene.addWall('A', {-30, -30}, {30, 30}, 20, {.members = {{1, 0}}});
            addBothSides(scene, 'W', uprightAtTheEye(turn, height, {-5, -3}, {7, 3}), {.members = {{1, 0}}});
            const Both both = drawBoth(scene, 64);
            std::int64_t unlike = 0;
            for (std::size_t i = 0; i < both.exact.ids.size(); ++i) {
                unlike += both.exact.ids[i] == both.fast.ids[i] ? 0 : 1;
                walls += both.exact.ids[i] == 'W' ? 1 : 0;
            }
            EXPECT_LE(unlike, 64) << turn << " degrees, " << height << " m: a column where the wall begins";
            EXPECT_EQ(std::count(both.fast.ids.begin(), both.fast.ids.end(), layout::kVoidId) +
                          std::count(both.fast.ids.begin(), both.fast.ids.end(), layout::kSkyId),
                      0)
                << turn << " degrees, " << height << " m";
            for (std::size_t row = 0; row < 64; ++row)
                for (const std::size_t column : {0u, 63u})
                    EXPECT_EQ(both.fast.ids[row * 64 + column], both.exact.ids[row * 64 + column])
                        << turn << " degrees, " << height << " m, row " << row;
        }
    }
    EXPECT_GT(walls, 20000);
}

/// A wall that faces the eye, 185 m from the origin of its coordinates: its corners have rests, as those of a loaded shell.
void addFarOriginWall(SceneBuilder& scene, float turn, float height) {
    const glm::vec3 origin(-151.3f, -97.7f, -40.1f);
    const std::size_t first = scene.upload.vertices.size();
    const std::array<glm::vec3, 4> left = uprightAtTheEye(turn, height, {-5, -3}, {7, 3});
    const std::array<glm::vec3, 4> right{left[3], left[2], left[1], left[0]};
    scene.addQuad(
        'W', height > 0.0f ? left : right,
        {.members = {{1, 0}}, .rows = {{{1, 0, 0, origin.x}, {0, 1, 0, origin.y}, {0, 0, 1, origin.z}}}});
    for (std::size_t i = first; i < scene.upload.vertices.size(); ++i) {
        layout::Vertex& vertex = scene.upload.vertices[i];
        const glm::dvec3 place = glm::dvec3(vertex.position) - glm::dvec3(origin);
        vertex.position = glm::vec3(place);
        vertex.rest = glm::vec3(place - glm::dvec3(vertex.position));
    }
}

// Decision 222: without the rests the corners of such a wall are micrometres off, and the wall is seen from its back or not at all.
TEST_F(FastGlTest, aWallMicrometresFromTheEyeIsSeen) {
    for (const float turn : {-41.0f, -34.0f, -7.0f, 3.0f, 20.0f}) {
        for (const float height : {-4e-6f, -2e-6f, -1e-6f, 1e-6f, 2e-6f, 4e-6f}) {
            SceneBuilder scene;
            scene.plan.constants.nearPlane = scene.plan.constants.clipFromEye[3][2] =
                static_cast<float>(kDefaultNearPlane);
            scene.root(1);
            scene.addWall('A', {-10, -10}, {10, 10}, 10, {.members = {{1, 0}}});
            addFarOriginWall(scene, turn, height);
            const Both both = drawBoth(scene, 64);
            std::int64_t unlike = 0, walls = 0;
            for (std::size_t i = 0; i < both.exact.ids.size(); ++i) {
                unlike += both.exact.ids[i] == both.fast.ids[i] ? 0 : 1;
                walls += both.exact.ids[i] == 'W' ? 1 : 0;
            }
            EXPECT_LE(unlike, 128) << turn << " degrees, " << height
                                   << " m: two columns where the wall begins";
            EXPECT_GT(walls, 200) << turn << " degrees, " << height << " m";
        }
    }
}

/// An upright pane through the eye's place moved by `height` metres, `turn` degrees from north, 3 m long and 2 m high.
SceneBuilder paneAtTheEye(float turn, float height) {
    SceneBuilder scene;
    scene.plan.constants.nearPlane = scene.plan.constants.clipFromEye[3][2] =
        static_cast<float>(kDefaultNearPlane);
    const std::uint32_t glass =
        scene.addMaterial({1, 0, 0, 0.5f}, layout::kNoTexture, layout::kMaterialAlpha);
    scene.root(1);
    scene.addWall('A', {-10, -10}, {10, 10}, 10, {.members = {{1, 0}}});
    addBothSides(scene, 'p', uprightAtTheEye(turn, height, {-1, -0.8f}, {2, 1.2f}),
                 {.members = {{1, 0}}, .material = glass, .program = frame::Program::Blended});
    return scene;
}

// docs/ray-rule.md#tolerances: no ray meets a surface in whose plane the eye is. One triangle of a pane covered a third of the picture.
TEST_F(FastGlTest, aPaneInTheEyesPlaneIsNotDrawn) {
    for (const float turn : {-61.0f, -34.0f, -7.0f, 3.0f, 20.0f, 45.0f, 58.0f}) {
        for (const float height : {-3e-7f, -1e-7f, 0.0f, 1e-7f, 3e-7f}) {
            SceneBuilder scene = paneAtTheEye(turn, height);
            const Both both = drawBoth(scene, 64, {.wantLayers = true});
            const auto pixels = [](const Frame& frame) {
                return std::count_if(frame.layers.begin(), frame.layers.end(),
                                     [](const LayerSum& sum) { return sum.count > 0; });
            };
            EXPECT_EQ(pixels(both.exact), 0) << turn << " degrees, " << height << " m";
            EXPECT_EQ(pixels(both.fast), 0) << turn << " degrees, " << height << " m";
            EXPECT_LE(difference(both.fast, both.exact), 1) << turn << " degrees, " << height << " m";
        }
        std::int64_t met = 0;
        for (const float height : {-2e-6f, 2e-6f, -1e-3f, 1e-3f}) {
            SceneBuilder scene = paneAtTheEye(turn, height);
            const Both both = drawBoth(scene, 64, {.wantLayers = true});
            std::int64_t unlike = 0;
            for (std::size_t i = 0; i < both.exact.layers.size(); ++i) {
                unlike += both.exact.layers[i] == both.fast.layers[i] ? 0 : 1;
                met += both.exact.layers[i].count > 0 ? 1 : 0;
            }
            EXPECT_LE(unlike, 64) << turn << " degrees, " << height << " m: a column of pixels";
        }
        EXPECT_GT(met, 1000) << turn << " degrees";
    }
}

// docs/ray-rule.md#spaces-portals-fillings: a pane comes before the surfaces in its opening's plane. Fast frames drew it behind the frame's trim.
TEST_F(FastGlTest, aPaneComesBeforeWhatIsInItsPlane) {
    for (const float turn : {-61.0f, -30.0f, -7.0f, 3.0f, 20.0f}) {
        for (const float height : {1.5e-4f, 3e-4f, 1e-3f, 4e-3f, 0.05f}) {
            for (const float before : {1e-4f, 3e-4f, 1e-2f}) {
                if (before >= height)
                    continue;
                SceneBuilder scene = paneAtTheEye(turn, height);
                for (std::size_t i = scene.upload.instances.size() - 2; i < scene.upload.instances.size();
                     ++i)
                    scene.upload.instances[i].membersAndKind |= layout::kKindFilling << 16;
                addBothSides(scene, 'b', uprightAtTheEye(turn, height - before, {-1, -0.5f}, {2, 0.0f}),
                             {.members = {{1, 0}}});
                const Both both = drawBoth(scene, 64, {.wantLayers = true});
                std::int64_t unlike = 0, covered = 0, hidden = 0;
                for (std::size_t i = 0; i < both.exact.layers.size(); ++i) {
                    unlike += both.exact.layers[i] == both.fast.layers[i] ? 0 : 1;
                    if (both.exact.ids[i] == 'b')
                        ++(both.exact.layers[i].count > 0 ? covered : hidden);
                }
                const std::string at = std::to_string(turn) + " degrees, " + std::to_string(height) +
                                       " and " + std::to_string(before) + " m";
                EXPECT_LE(unlike, 64) << at << ": a row or column of pixels";
                EXPECT_GT(before < 2e-4f ? covered : hidden, 100) << at;
                EXPECT_LE(before < 2e-4f ? hidden : covered, 64) << at;
            }
        }
    }
}

TEST_F(FastGlTest, blendsTerrain_withPackedLayersAndWithout) {
    for (const bool byIndex : {true, false}) {
        SceneBuilder scene;
        scene.root(0);
        const std::uint32_t base = checkered(scene), over = scene.addTexture(1, 1, {0, 100, 40, 255}, false);
        const std::uint32_t road = scene.addTexture(1, 1, {20, 30, 10, 255}, false);
        const std::uint32_t map =
            scene.addTexture(2, 2, {0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 128, 0, 0, 0, 60}, true);
        layout::TerrainCell cell;
        cell.base = {base, layout::kNoTexture, 0, 2.0f};
        cell.overlays[0] = {over, map, 1, 1.0f};
        cell.overlays[1] = cell.overlays[2] = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
        cell.roads[0] = {road, map, 2, 1.0f};
        cell.roads[1] = {road, map, 3, 1.0f};
        scene.upload.terrainCells.push_back(cell);
        scene.addWall('T', {-2, -2}, {2, 2}, 2,
                      {.program = frame::Program::Terrain, .uv = {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
        RendererOptions options = fast();
        options.textures.pagesByIndex = byIndex;
        const Both both = drawBoth(scene, 32, {.wantIds = false}, options);
        EXPECT_LE(difference(both.exact, both.fast), 3) << byIndex;
        Frame white = both.fast;
        std::fill(white.colour.begin(), white.colour.end(), std::uint8_t{255});
        EXPECT_GT(difference(both.fast, white), 100);
    }
}

// Each layer shows in a part of the cell, by the turns of one map: a quarter, or a quarter and a soft border.
TEST_F(FastGlTest, blendsTerrain_whereItsLayersShow) {
    constexpr std::uint32_t kMap = 64;
    std::vector<std::uint8_t> quarter(std::size_t{4} * kMap * kMap, 255);
    for (std::uint32_t y = 0; y < kMap / 2; ++y)
        for (std::uint32_t x = 0; x < kMap / 2 + y % 9; ++x)
            quarter[4 * (y * kMap + x) + 3] = static_cast<std::uint8_t>(x < kMap / 3 ? 0 : 4 * x);
    for (std::uint32_t turns = 0; turns < 4; ++turns) {
        SceneBuilder scene;
        scene.root(0);
        const std::uint32_t base = scene.addTexture(1, 1, {250, 250, 240, 255}, false),
                            red = scene.addTexture(1, 1, {200, 10, 0, 255}, false),
                            green = scene.addTexture(1, 1, {0, 100, 40, 255}, false),
                            road = scene.addTexture(1, 1, {20, 30, 10, 255}, false),
                            map = scene.addTexture(kMap, kMap, quarter, true);
        layout::TerrainCell cell;
        cell.base = {base, layout::kNoTexture, 0, 2.0f};
        cell.overlays[0] = {red, map, turns, 3.0f};
        cell.overlays[1] = {green, map, (turns + 1) & 3u, 1.0f};
        cell.overlays[2] = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
        cell.roads[0] = {road, map, (turns + 2) & 3u, 1.0f};
        cell.roads[1] = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
        scene.upload.terrainCells.push_back(cell);
        scene.addWall('T', {-2, -2}, {2, 2}, 2,
                      {.program = frame::Program::Terrain, .uv = {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
        const Both both = drawBoth(scene, 90, {.wantIds = false}, fast());
        EXPECT_LE(difference(both.exact, both.fast), 3) << turns;
    }
}

TEST_F(FastGlTest, lightsLikeTheExactWay) {
    for (const std::uint32_t kind : {layout::kLitWalls, layout::kLitThing, layout::kLitMoving}) {
        SceneBuilder scene;
        scene.root(1);
        scene.plan.constants.viewerLight = {-1, 0, 0, 0.5f};
        scene.plan.lamps = {{{1, 1, 1, 6}, {0.5f, 0.4f, 0.3f, 0.7f}},
                            {{-1, 1, 1, 4}, {0.1f, 0.4f, 0.3f, 2.0f}}};
        scene.upload.lamps = 2;
        scene.upload.lampRefs = {1, 0};
        scene.upload.lightSets.push_back({kind, 0, 2, 1});
        scene.plan.constants.sealedAmbient = {0.1f, 0.1f, 0.1f, 0};
        scene.addWall('a', {-2, -2}, {2, 2}, 2, {.members = {{1, 1}}}); // one large quad
        const Both both = drawBoth(scene, 16, {.wantIds = false});
        EXPECT_LE(difference(both.exact, both.fast), 1) << kind;
        std::set<std::uint8_t> reds;
        for (std::size_t i = 0; i < both.fast.colour.size(); i += 4)
            reds.insert(both.fast.colour[i]);
        EXPECT_GT(reds.size(), 8u) << "corners differ";
        for (layout::Lamp& lamp : scene.plan.lamps)
            lamp.colour.w = 0;
        const Both dark = drawBoth(scene, 16, {.wantIds = false});
        EXPECT_GT(difference(both.fast, dark.fast), 10) << kind;
    }
}

TEST_F(FastGlTest, aFrameStaysWithinTheBudgetOfCalls_andNullDeviceCountsThemAlike) {
    std::set<std::uint32_t> counts;
    for (const int copies : {1, 30}) {
        SceneBuilder scene = rooms();
        for (int i = 1; i < copies; ++i)
            scene.addWall('d', {0, 0}, {1, 1}, 5.0f + static_cast<float>(i),
                          {.members = {{1, 0}}, .gated = i % 2 == 0});
        scene.upload.terrainCells.resize(1);
        scene.upload.terrainCells[0].base = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
        scene.plan.constants.voidColour =
            StateTracker::kFirstClearColour; // another takes a call more in the first frame
        const frame::FramePlan& plan = scene.finish(true);
        counts.merge(countCalls(scene.upload, plan, {.wantIds = false}));
    }
    EXPECT_EQ(counts.size(), 1u) << "independent of draws and of earlier frames";
}

/// Twelve walls of one mesh in a row, each with an id of its own, half of them seen through an opening, and a mesh of three
/// walls above them, before a background.
SceneBuilder alike() {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({0, -6}, {6, 6}, 4, 2, 0);
    for (std::uint32_t i = 0; i < 12; ++i) {
        const std::uint32_t zone = i < 6 ? 1 : 2;
        scene.addWall('a' + i, {-6, -6}, {-5, 0}, 6,
                      {.members = {{zone, 0}},
                       .gated = true,
                       .rows = {glm::vec4{1, 0, 0, static_cast<float>(i)}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
        layout::DrawPiece& piece = scene.upload.pieces.back();
        piece.firstIndex = scene.upload.pieces.front().firstIndex;
    }
    const auto column = [](float x) {
        return std::array<glm::vec3, 4>{glm::vec3{x, 6, 1}, {x + 1, 6, 1}, {x + 1, 6, 5}, {x, 6, 5}};
    };
    const std::array<std::array<glm::vec3, 4>, 3> columns{column(-5), column(-3), column(-1)};
    scene.addQuads('X', columns, {.members = {{1, 0}}, .gated = true});
    scene.addWall('=', {-9, -9}, {9, 9}, 7,
                  {.members = {{1, 0}, {2, 0}}, .gated = true}); // cracks are filled
    return scene;
}

TEST_F(FastGlTest, drawsOfOneMeshShowWhatTheyShowOneByOne) {
    SceneBuilder scene = alike();
    const Both both = drawBoth(scene, 64);
    EXPECT_EQ(both.fast.picture(), both.exact.picture());
    const std::set<std::uint32_t> shown(both.fast.ids.begin(), both.fast.ids.end());
    for (std::uint32_t i = 0; i < 12; ++i)
        EXPECT_EQ(shown.count('a' + i), 1u) << i;
}

TEST_F(FastGlTest, drawsOfOneMeshAreOneCommand_afterThoseOfLargerMeshes) {
    SceneBuilder scene = alike();
    NullDevice null;
    Renderer renderer(null, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    Result<RenderTarget> target = RenderTarget::create(null, 8, 8);
    ASSERT_TRUE(target && renderer.render(scene.finish(), *target));
    std::vector<layout::DrawCommand> drawn;
    for (const NullDevice::Command& command : null.commands()) {
        if (command.kind != NullDevice::CommandKind::DrawIndirect)
            continue;
        for (std::size_t i = 0; i < command.b; ++i) {
            layout::DrawCommand& each = drawn.emplace_back();
            std::memcpy(&each, null.ring().data() + command.a + i * sizeof each, sizeof each);
        }
    }
    ASSERT_EQ(drawn.size(), 3u);
    EXPECT_EQ(drawn[0].indexCount, 18u);
    EXPECT_EQ(drawn[0].instanceCount, 1u);
    EXPECT_EQ(drawn[1].indexCount, 6u);
    EXPECT_EQ(drawn[1].instanceCount, 12u);
    EXPECT_EQ(drawn[1].baseInstance, drawn[0].baseInstance + 1) << "records follow each other";
    EXPECT_EQ(drawn[2].baseInstance, drawn[1].baseInstance + 12);
}

// Most vertices are those of cut-outs: plants.
TEST_F(FastGlTest, aProcessorBeginsWithWallsAndGroundBeforeTheCutOuts) {
    using Kind = NullDevice::CommandKind;
    const auto kindsOf = [&](bool software, const RenderOptions& options) {
        Capabilities capabilities;
        capabilities.software = software;
        NullDevice null(capabilities);
        Renderer renderer(null, fast());
        SceneBuilder scene = rooms();
        EXPECT_TRUE(renderer.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(null, 8, 8);
        EXPECT_TRUE(target && renderer.render(scene.finish(true), *target, options));
        std::vector<Kind> kinds;
        for (const NullDevice::Command& command : null.commands())
            kinds.push_back(command.kind);
        return kinds;
    };
    const auto count = [](const std::vector<Kind>& kinds, Kind kind) {
        return std::count(kinds.begin(), kinds.end(), kind);
    };
    const std::vector<Kind> kinds = kindsOf(true, {.wantIds = false});
    ASSERT_EQ(count(kinds, Kind::Flush), 1);
    EXPECT_EQ(count(kinds, Kind::ClearPicture), 1);
    EXPECT_EQ(count(kinds, Kind::Clear), 1) << "of owners";
    const auto flush = std::find(kinds.begin(), kinds.end(), Kind::Flush);
    EXPECT_EQ(std::count(kinds.begin(), flush, Kind::DrawIndirect), 4)
        << "walls and ground, each with and without a test";
    for (const std::vector<Kind>& others :
         {kindsOf(false, {.wantIds = false}), kindsOf(true, {.wantIds = true})}) {
        EXPECT_EQ(count(others, Kind::Flush), 0);
        EXPECT_EQ(count(others, Kind::ClearPicture), 0);
    }
}

TEST_F(FastGlTest, pixelsWithoutASurfaceHaveTheColourOfTheFramesOwnPlan) {
    SceneBuilder scene;
    scene.root(1);
    scene.addWall('A', {0, -9}, {9, 9}, 2, {.members = {{1, 0}}});
    scene.finish();
    std::erase_if(scene.plan.stages,
                  [](const frame::Stage& stage) { return stage.kind == frame::StageKind::Sky; });
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    for (const layout::vec4& colour :
         {layout::vec4(0, 0.2f, 1, 1), layout::vec4(1, 0, 0.4f, 1), layout::vec4(0, 0.2f, 1, 1)}) {
        scene.plan.constants.voidColour = colour;
        const Frame frame = renderWith(renderer, scene.plan, 8, 8, {.wantIds = false});
        for (int channel = 0; channel < 4; ++channel)
            EXPECT_EQ(frame.colour[static_cast<std::size_t>(channel)], std::lround(255 * colour[channel]));
    }
}

// Objects of the sky cover the upper half, and the plain sky is drawn below it alone, but in frames with ids.
TEST_F(FastGlTest, thePlainSkyIsDrawnInItsRectangle_andEverywhereIfItsIdIsWanted) {
    SceneBuilder scene;
    scene.root(0);
    scene.plan.constants.fogColour = scene.plan.constants.skyZenith = {0, 0, 1, 1};
    scene.plan.constants.voidColour = {1, 0, 0, 1};
    const std::uint32_t plain = scene.addMaterial({0, 1, 0, 1});
    scene.addSky({-1, 0}, {1, 1}, 1, plain, 1.0f);
    scene.finish();
    Renderer renderer(*device_, fast());
    ASSERT_TRUE(renderer.upload(scene.upload));
    const auto coloursOf = [&](bool wantIds) {
        const Frame frame = renderWith(renderer, scene.plan, 8, 8, {.wantIds = wantIds});
        std::map<std::array<std::uint8_t, 3>, int> colours;
        for (std::size_t i = 0; i < frame.colour.size(); i += 4)
            ++colours[{frame.colour[i], frame.colour[i + 1], frame.colour[i + 2]}];
        return colours;
    };
    using Colours = std::map<std::array<std::uint8_t, 3>, int>;
    const Colours whole{{{0, 255, 0}, 32}, {{0, 0, 255}, 32}};
    EXPECT_EQ(coloursOf(false), whole);
    scene.plan.rects = {{-1, -1, 1, 0}};
    scene.plan.plainSky = {0, 1};
    EXPECT_EQ(coloursOf(false), whole);
    scene.plan.rects = {{-1, -1, 1, -0.5f}};
    const Colours less{{{0, 255, 0}, 32}, {{0, 0, 255}, 16}, {{255, 0, 0}, 16}};
    EXPECT_EQ(coloursOf(false), less) << "the plan says that objects cover the rest";
    EXPECT_EQ(coloursOf(true), whole);
}

TEST_F(FastGlTest, multisampledFramesShowTheSame) {
    SceneBuilder scene = rooms();
    const frame::FramePlan& plan = scene.finish();
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
        Renderer renderer(*device_, {.drawing = drawing});
        ASSERT_TRUE(renderer.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(*device_, 32, 32, {.samples = layout::kSamples});
        ASSERT_TRUE(target);
        ASSERT_TRUE(renderer.render(plan, *target, {.wantIds = false}));
        pictures.push_back(target->readColour());
    }
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < pictures[0].size(); ++i)
        unlike += std::abs(int{pictures[0][i]} - int{pictures[1][i]}) > 8 ? 1 : 0;
    EXPECT_LT(unlike, pictures[0].size() / 20) << "edges alone";
}

} // namespace
} // namespace limen::gpu::test
