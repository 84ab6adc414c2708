#include "GlFixture.h"

#include <cmath>

namespace limen::gpu::test {
namespace {

using Defines = std::vector<std::string>; // as frame/ReadingDefines.h makes them

/// Readings of light and fog that shaders follow, in both ways of drawing: a wall 2 m north of the eye.
class ReadingsGlTest : public GlTest {
protected:
    static constexpr std::uint32_t kSize = 9; ///< the middle pixel is straight ahead

    struct Lit {
        std::uint32_t kind = layout::kLitOutdoors; ///< LightSet.kind
        frame::Program program = frame::Program::Opaque;
        float luminosity = 0, diffuse = 1, scale = 1;
    };
    /// A white wall in light set 1, without any light of its own.
    static SceneBuilder wall(const Lit& lit) {
        SceneBuilder scene;
        const bool isOutdoors = lit.kind == layout::kLitOutdoors;
        scene.root(isOutdoors ? 0 : 1);
        scene.plan.constants.landAmbient = scene.plan.constants.skyAmbient = {0, 0, 0, 0};
        scene.upload.lightSets.push_back({lit.kind, 0, 0, 0});
        const bool isBlended = lit.program == frame::Program::Blended;
        const std::uint32_t material =
            scene.addMaterial({1, 1, 1, 1}, layout::kNoTexture, isBlended ? layout::kMaterialAlpha : 0);
        scene.upload.materials.back().luminosity = lit.luminosity;
        scene.upload.materials.back().diffuse = lit.diffuse;
        const float half = 4 / lit.scale;
        scene.addWall('A', glm::vec2(-half), glm::vec2(half), 2 / lit.scale,
                      {.members = {{isOutdoors ? 0u : 1u, 1}},
                       .material = material,
                       .program = lit.program,
                       .rows = {glm::vec4{lit.scale, 0, 0, 0}, glm::vec4{0, lit.scale, 0, 0},
                                glm::vec4{0, 0, lit.scale, 0}}});
        return scene;
    }
    /// One lamp, `distance` metres before the wall's middle, that lights it alike in both ways.
    static void addLamp(SceneBuilder& scene, float intensity) {
        scene.upload.lightSets.back().lampCount = 1;
        scene.plan.lamps = {{{0, -1000, 0, 1e6f}, {glm::vec3(1), intensity}}};
        scene.upload.lamps = 1;
        scene.upload.lampRefs = {0};
    }
    glm::ivec3 drawn(SceneBuilder& scene, Drawing drawing, const Defines& defines) {
        scene.upload.defines = defines;
        const frame::FramePlan& plan = scene.finish();
        Renderer renderer(*device_, {.drawing = drawing});
        const Result<void> uploaded = renderer.upload(scene.upload);
        EXPECT_TRUE(uploaded) << uploaded.error().message();
        const Frame frame = renderWith(renderer, plan, kSize, kSize, {.wantIds = false});
        calls_ = renderer.report().glCalls;
        return frame.at(kSize / 2, kSize / 2);
    }
    /// Expects grey of this share of white, in both ways.
    void expectGrey(SceneBuilder& scene, const Defines& defines, double share, const std::string& what) {
        for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
            const glm::ivec3 colour = drawn(scene, drawing, defines);
            EXPECT_NEAR(colour.x, 255 * share, 1.5)
                << what << (drawing == Drawing::Fast ? " fast" : " exact");
            EXPECT_EQ(colour.x, colour.y) << what;
        }
    }
    std::uint32_t calls_ = 0;
};

TEST_F(ReadingsGlTest, cellsHaveNoFog_outdoorsHas) {
    for (const frame::Program program :
         {frame::Program::Opaque, frame::Program::CutOut, frame::Program::Blended}) {
        for (const auto& [kind, share] : {std::pair{layout::kLitOutdoors, 0.5},
                                          {layout::kLitWalls, 1.0},
                                          {layout::kLitThing, 1.0},
                                          {layout::kLitMoving, 1.0}}) {
            SceneBuilder scene = wall({.kind = kind, .program = program});
            scene.plan.constants.skyAmbient = {1, 1, 1, 0};
            scene.plan.constants.fogColour = {0, 0, 0, 1};
            // Far beyond the wall and so even over it: fast fog is that of the corners.
            scene.plan.constants.fogRange = {-1e6f, 1e6f, 0, 0};
            expectGrey(scene, {"NO_CELL_FOG"}, share, "none in cells " + std::to_string(kind));
            expectGrey(scene, {}, 0.5, "default " + std::to_string(kind));
        }
    }
}

TEST_F(ReadingsGlTest, bakedLightReplacesTheLuminosityOfWalls_notOfThings) {
    for (const auto& [kind, share] :
         {std::pair{layout::kLitWalls, 0.1}, {layout::kLitThing, 0.5}, {layout::kLitOutdoors, 0.5}}) {
        SceneBuilder scene = wall({.kind = kind, .luminosity = 0.4f});
        scene.plan.constants.skyAmbient = {0.1f, 0.1f, 0.1f, 0};
        expectGrey(scene, {"BAKED_LIGHT_REPLACES"}, share, "replaced " + std::to_string(kind));
        expectGrey(scene, {}, 0.5, "default " + std::to_string(kind));
    }
    SceneBuilder lamplit = wall({.kind = layout::kLitWalls, .luminosity = 0.4f});
    addLamp(lamplit, 2.5e5f); // (1/2 + 1) / 1.5 / 1002^2 of it, a quarter
    expectGrey(lamplit, {"BAKED_LIGHT_REPLACES"}, 0.249, "baked light is left");
    expectGrey(lamplit, {}, 0.649, "default: the sum");
}

TEST_F(ReadingsGlTest, theDiffuseValueIsAFactorOfTheSun_notOfOtherLight) {
    for (const frame::Program program :
         {frame::Program::Opaque, frame::Program::CutOut, frame::Program::Blended}) {
        SceneBuilder scene = wall({.program = program, .diffuse = 0.25f});
        scene.plan.constants.skyAmbient = {0.2f, 0.2f, 0.2f, 0};
        scene.plan.constants.sunColour = {0.8f, 0.8f, 0.8f, 0};
        scene.plan.constants.sunDirection = {0.6f, -0.8f, 0, 0};
        expectGrey(scene, {"SURFACE_DIFFUSE"}, 0.2 + 0.25 * 0.64, "of the sun");
        expectGrey(scene, {}, 0.84, "default");
    }
}

TEST_F(ReadingsGlTest, greyWallsHaveAShareOfTheLightThatIsNotBaked) {
    for (const auto& [kind, share] : {std::pair{layout::kLitWalls, 0.5}, {layout::kLitThing, 1.0}}) {
        SceneBuilder scene = wall({.kind = kind, .luminosity = 0.1f});
        scene.plan.constants.skyAmbient = {0.2f, 0.2f, 0.2f, 0};
        // Far away, and within reach of the wall: 0.4 of white everywhere.
        expectGrey(scene, {"WALL_GREY 0.500000"}, 0.1 + share * 0.2, "ambient " + std::to_string(kind));
        expectGrey(scene, {}, 0.3, "default");
    }
    SceneBuilder lamplit = wall({.kind = layout::kLitWalls});
    addLamp(lamplit, 2.5e5f);
    expectGrey(lamplit, {"WALL_GREY 0.500000"}, 0.249, "baked light stays");
}

TEST_F(ReadingsGlTest, greyWallsHaveAShareOfTheViewersLight) {
    for (const bool perPixel : {false, true}) {
        SceneBuilder scene = wall({.kind = layout::kLitWalls});
        scene.plan.constants.flags = perPixel ? layout::kFramePixelLamps : 0;
        scene.plan.constants.viewerLight = {0, -3, 0, 2.25f};
        for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
            const int whole = drawn(scene, drawing, {}).x,
                      half = drawn(scene, drawing, {"WALL_GREY 0.500000"}).x;
            EXPECT_GT(whole, 20);
            EXPECT_NEAR(half, 0.5 * whole, 1) << perPixel;
        }
    }
}

TEST_F(ReadingsGlTest, normalsOfScaledObjectsHaveUnitLength_orFollowTheScale) {
    for (const float scale : {0.5f, 1.0f, 2.0f}) {
        SceneBuilder scene = wall({.scale = scale});
        scene.plan.constants.sunColour = {0.4f, 0.4f, 0.4f, 0};
        scene.plan.constants.sunDirection = {0, -1, 0, 0};
        expectGrey(scene, {}, 0.4, "default");
        expectGrey(scene, {"NORMALS_SCALED"}, 0.4 * scale, "scaled");
        expectGrey(scene, {"NORMALS_DIVIDED"}, 0.4 / scale, "divided");
    }
    SceneBuilder unlit = wall({});
    unlit.plan.constants.sunColour = {1, 1, 1, 0};
    for (layout::Vertex& vertex : unlit.upload.vertices)
        vertex.normal = 0;
    for (const char* define : {"NORMALS_SCALED", "NORMALS_DIVIDED"})
        expectGrey(unlit, {define}, 0.0, "normals of 0 stay 0");
}

TEST_F(ReadingsGlTest, grainOfTheGroundIsUnlit_butUnderFog) {
    SceneBuilder scene;
    scene.root(0);
    const std::uint32_t plain = scene.addTexture(1, 1, {200, 200, 200, 255}, false),
                        grain = scene.addTexture(1, 1, {100, 100, 100, 128}, false);
    scene.upload.details = {grain, layout::kNoTexture, layout::kNoTexture};
    scene.plan.constants.detailTextures = {grain, 0, 0, 0};
    scene.plan.constants.detailTiling = {4, 0, 0, 0};
    scene.plan.constants.landAmbient = {0.4f, 0.4f, 0.4f, 0};
    scene.plan.constants.fogColour = {0, 0, 0, 1};
    layout::TerrainCell cell;
    cell.base = {plain, layout::kNoTexture, 0, 1};
    for (layout::TerrainLayer& layer : cell.overlays)
        layer.texture = layout::kNoTexture;
    for (layout::TerrainLayer& layer : cell.roads)
        layer.texture = layout::kNoTexture;
    scene.upload.terrainCells.push_back(cell);
    scene.addWall('T', {-4, -4}, {4, 4}, 2, {.program = frame::Program::Terrain});
    for (layout::Instance& instance : scene.upload.instances)
        instance.membersAndKind = (instance.membersAndKind & layout::kMostMembers) | 1u << 16; // ground
    const double ground = 200 / 255.0, grains = 100 / 255.0, covered = 128 / 255.0;
    for (const bool isFoggy : {false, true}) {
        scene.plan.constants.fogRange = isFoggy ? glm::vec4(-1e6f, 1e6f, 0, 0) : glm::vec4(1e6f, 2e6f, 0, 0);
        const double clear = isFoggy ? 0.5 : 1.0;
        expectGrey(scene, {"GRAIN_UNLIT"}, clear * (0.4 * ground * (1 - covered) + grains * covered),
                   "unlit");
        expectGrey(scene, {}, clear * 0.4 * (ground * (1 - covered) + grains * covered), "default");
    }
}

TEST_F(ReadingsGlTest, makeNoCallsAndLeaveIdsAsTheyAre) {
    const Defines all{"NO_CELL_FOG",    "BAKED_LIGHT_REPLACES", "SURFACE_DIFFUSE",
                      "NORMALS_SCALED", "GRAIN_UNLIT",          "WALL_GREY 0.500000"};
    for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
        SceneBuilder scene = wall({.kind = layout::kLitWalls});
        std::vector<std::vector<std::uint32_t>> ids;
        std::vector<std::uint32_t> calls;
        for (const Defines& defines : {Defines{}, all}) {
            scene.upload.defines = defines;
            Renderer renderer(*device_, {.drawing = drawing});
            ASSERT_TRUE(renderer.upload(scene.upload));
            ids.push_back(renderWith(renderer, scene.finish(), kSize, kSize, {.wantIds = true}).ids);
            calls.push_back(renderer.report().glCalls);
        }
        EXPECT_EQ(ids[0], ids[1]);
        EXPECT_EQ(calls[0], calls[1]);
    }
}

TEST_F(ReadingsGlTest, scenesOfOneRendererHaveProgramsOfTheirOwn) {
    SceneBuilder scene = wall({.kind = layout::kLitWalls, .luminosity = 0.4f});
    const frame::FramePlan& plan = scene.finish();
    Renderer renderer(*device_, {.drawing = Drawing::Fast});
    for (const auto& [defines, value] :
         {std::pair{Defines{}, 102}, {Defines{"BAKED_LIGHT_REPLACES"}, 0}, {Defines{}, 102}}) {
        scene.upload.defines = defines;
        ASSERT_TRUE(renderer.upload(scene.upload));
        EXPECT_NEAR(renderWith(renderer, plan, kSize, kSize, {.wantIds = false}).at(4, 4).x, value, 1);
    }
}

} // namespace
} // namespace limen::gpu::test
