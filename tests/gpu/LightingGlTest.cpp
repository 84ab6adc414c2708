#include "GlFixture.h"
#include "IsColour.h"

#include <tuple>

namespace limen::gpu::test {
namespace {

// A small white wall 2 m north, lit by light set 1. Colours have 8 bits.
class LightingGlTest : public GlTest {
protected:
    static constexpr float kHalf = 0.004f; ///< of the wall's side: its corners are lit alike
    static SceneBuilder wallLitBy(const layout::LightSet& set, std::uint32_t material = 0) {
        SceneBuilder scene;
        scene.root(1);
        scene.plan.constants.landAmbient = scene.plan.constants.skyAmbient = {0, 0, 0, 0};
        scene.upload.lightSets.push_back(set);
        scene.addWall('A', glm::vec2(-kHalf), glm::vec2(kHalf), 2,
                      {.members = {{1, 1}}, .material = material});
        // Wide enough for a picture of one pixel.
        scene.plan.constants.clipFromEye[0].x = scene.plan.constants.clipFromEye[2].y = 2.0f / kHalf;
        return scene;
    }
    /// A wall lit by one lamp, `distance` metres before it.
    static SceneBuilder wallBeforeALamp(std::uint32_t kind, float distance, float intensity,
                                        float falloff = 10, const glm::vec3& colour = glm::vec3(1)) {
        SceneBuilder scene = wallLitBy({kind, 0, 1, 1});
        scene.plan.lamps = {{{0, 2 - distance, 0, falloff}, {colour, intensity}}};
        scene.upload.lamps = 1;
        scene.upload.lampRefs = {0};
        return scene;
    }
    glm::ivec3 colourOf(SceneBuilder& scene) { return render(scene, 1).at(0, 0); }
    static int byteOf(double share) { return static_cast<int>(share * 255.0); }
};

TEST_F(LightingGlTest, ambientLightOfTheSky_andOfSealedCells) {
    for (const std::uint32_t sealed : {0u, 1u}) {
        SceneBuilder scene = wallLitBy({layout::kLitWalls, 0, 0, sealed});
        scene.plan.constants.skyAmbient = {0.2f, 0.4f, 0.6f, 0};
        scene.plan.constants.sealedAmbient = {0.8f, 0, 0, 0};
        scene.plan.constants.sunColour = {1, 1, 1, 0}; // never in cells
        EXPECT_EQ(colourOf(scene), sealed == 0 ? glm::ivec3(51, 102, 153) : glm::ivec3(204, 0, 0));
    }
}

TEST_F(LightingGlTest, sunByTheAngle_clampedWithTheAmbientLight) {
    SceneBuilder scene = wallLitBy({layout::kLitOutdoors, 0, 0, 0});
    scene.plan.constants.sunColour = {1, 0.5f, 0, 0};
    scene.plan.constants.sunDirection = {0.6f, -0.8f, 0, 0};
    EXPECT_EQ(colourOf(scene), glm::ivec3(204, 102, 0));
    scene.plan.constants.skyAmbient = {0.5f, 0.1f, 0.2f, 0};
    EXPECT_THAT(colourOf(scene), IsColour(255, 128, 51));
    scene.plan.constants.sunDirection = {0, 1, 0, 0}; // behind the wall
    EXPECT_THAT(colourOf(scene), IsColour(128, 26, 51));
}

TEST_F(LightingGlTest, groundHasAnAmbientLightOfItsOwn_cutToBytes) {
    SceneBuilder scene;
    scene.root(0);
    scene.plan.constants.landAmbient = {0.4f, 0.4f, 0.4f, 0};
    scene.plan.constants.sunColour = {0.5f, 0.5f, 0.5f, 0};
    scene.upload.terrainCells.resize(1);
    scene.upload.terrainCells[0].base = {scene.addTexture(1, 1, {255, 255, 255, 255}), layout::kNoTexture, 0,
                                         1};
    for (layout::TerrainLayer& layer : scene.upload.terrainCells[0].overlays)
        layer.texture = layout::kNoTexture;
    for (layout::TerrainLayer& layer : scene.upload.terrainCells[0].roads)
        layer.texture = layout::kNoTexture;
    scene.addWall('T', {-2, -2}, {2, 2}, 2, {.program = frame::Program::Terrain});
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(229)) << "0.9 of 255 is 229.5";
}

TEST_F(LightingGlTest, lampsAreBakedIntoWalls) {
    for (const auto& [distance, intensity, value] : {std::tuple{2.0f, 1.0f, 0.211538},
                                                     {13.0f, 1.0f, 0.0},
                                                     {0.5f, 1.0f, 0.961538},
                                                     {2.0f, 100.0f, 1.0}}) {
        SceneBuilder scene = wallBeforeALamp(layout::kLitWalls, distance, intensity);
        EXPECT_NEAR(colourOf(scene).x, byteOf(value), 1) << distance << " " << intensity;
    }
    SceneBuilder coloured = wallBeforeALamp(layout::kLitWalls, 2, 100, 10, {1, 0.4f, 0.2f});
    EXPECT_EQ(colourOf(coloured), glm::ivec3(255, 102, 51)) << "at most the lamp's own colour";
    SceneBuilder unlit = wallBeforeALamp(layout::kLitWalls, 2, 1);
    for (layout::Vertex& vertex : unlit.upload.vertices)
        vertex.normal = 0;
    EXPECT_NEAR(colourOf(unlit).x, byteOf(0.0705128), 1) << "without a normal";
}

TEST_F(LightingGlTest, lampsShineOnThingsByTheirDistance) {
    for (const auto& [distance, value] :
         {std::pair{2.0f, 0.5}, {5.0f, 0.2}, {14.9f, 1 / 14.9}, {15.1f, 0.0}}) {
        SceneBuilder scene = wallBeforeALamp(layout::kLitThing, distance, 1);
        EXPECT_NEAR(colourOf(scene).x, byteOf(value), 1) << distance;
    }
    SceneBuilder bright = wallBeforeALamp(layout::kLitThing, 2, 100, 10, {1, 0.4f, 0});
    EXPECT_EQ(colourOf(bright), glm::ivec3(255, 255, 0)) << "colour times intensity";
    SceneBuilder unlit = wallBeforeALamp(layout::kLitThing, 2, 1);
    for (layout::Vertex& vertex : unlit.upload.vertices)
        vertex.normal = 0;
    EXPECT_EQ(colourOf(unlit), glm::ivec3(0));
}

TEST_F(LightingGlTest, aThingHasEightLamps_theViewersLightAmongThem) {
    SceneBuilder scene = wallLitBy({layout::kLitThing, 0, 9, 1});
    scene.plan.lamps.assign(9, {{0, 1, 0, 10}, {0.05f, 0.05f, 0.05f, 1}});
    scene.upload.lamps = 9;
    scene.upload.lampRefs = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_NEAR(colourOf(scene).x, byteOf(0.40), 1);
    scene.plan.constants.viewerLight = {0, 0, 0, 0.2f}; // 2 m away
    EXPECT_NEAR(colourOf(scene).x, byteOf(0.35 + 0.1), 1);
}

TEST_F(LightingGlTest, aMovingThingHasTheLampsNearIt) {
    for (const float falloff : {0.9f, 1.1f}) { // its origin is 2 m from the lamp: its radius counts as 1 m
        SceneBuilder scene = wallBeforeALamp(layout::kLitMoving, 0.5f, 0.25f, falloff);
        scene.plan.lamps[0].position.y = 1.5f;
        for (layout::Instance& instance : scene.upload.instances)
            instance.pose2.z = -0.5f; // the origin; vertices follow it
        for (layout::Vertex& vertex : scene.upload.vertices)
            vertex.position.y += 0.5f;
        EXPECT_NEAR(colourOf(scene).x, falloff < 1 ? 0 : byteOf(0.5), 1) << falloff;
    }
}

TEST_F(LightingGlTest, theViewersLightIsInCells) {
    for (const auto& [kind, light] : {std::pair{layout::kLitWalls, 0.45},
                                      {layout::kLitThing, 0.45},
                                      {layout::kLitMoving, 0.45},
                                      {layout::kLitOutdoors, 0.0}}) {
        SceneBuilder scene = wallLitBy({kind, 0, 0, 0});
        scene.plan.constants.viewerLight = {0, -3, 0, 2.25f};
        EXPECT_NEAR(colourOf(scene).x, byteOf(light), 1) << kind;
        scene.plan.constants.viewerLight.y = -13.5f; // beyond 15 m
        EXPECT_EQ(colourOf(scene).x, 0) << kind;
    }
}

TEST_F(LightingGlTest, luminosityIsAdded_andTheSumClampedBeforeTheColour) {
    for (const auto& [ambient, light] : {std::pair{0.2f, 0.6f}, {0.9f, 1.0f}}) {
        SceneBuilder scene = wallLitBy({layout::kLitThing, 0, 0, 1}, 1);
        scene.plan.constants.sealedAmbient = {ambient, ambient, ambient, 0};
        scene.addMaterial({1, 0.5f, 0, 1});
        scene.upload.materials.back().luminosity = 0.4f;
        const glm::ivec3 colour = colourOf(scene);
        EXPECT_NEAR(colour.x, 255 * light, 1);
        EXPECT_NEAR(colour.y, 127.5 * light, 1);
    }
}

TEST_F(LightingGlTest, fogIsEverywhere_butOnAdditiveSurfaces) {
    for (const std::uint32_t zone : {0u, 1u}) {
        SceneBuilder scene;
        scene.root(zone);
        scene.addWall('A', {-2, -2}, {2, 2}, 2, {.members = {{zone, 0}}});
        scene.plan.constants.fogColour = {1, 0, 0, 1};
        scene.plan.constants.fogRange = {1, 3, 0, 0};
        const Frame frame = render(scene, 9); // the middle pixel is 2 m away: half fog
        EXPECT_THAT(frame.at(4, 4), IsColour(255, 128, 128)) << zone;
    }
    SceneBuilder scene;
    scene.root(0);
    scene.plan.constants.voidColour = {0, 0, 0, 1};
    const std::uint32_t additive =
        scene.addMaterial({0, 0.5f, 0, 1}, layout::kNoTexture, layout::kMaterialAdditive);
    scene.addWall('B', {-2, -2}, {2, 2}, 2, {.material = additive, .program = frame::Program::Blended});
    scene.plan.constants.fogColour = {1, 0, 0, 1};
    scene.plan.constants.fogRange = {1, 1.5f, 0, 0};
    const glm::ivec3 colour = render(scene, 9).at(4, 4);
    EXPECT_NEAR(colour.y, 128, 1);
}

TEST_F(LightingGlTest, highlightCoversByItsAlpha) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-2, -2}, {2, 2}, 2, {.highlight = 0xFF00FF00u}); // A,B,G,R: green, full strength
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(0, 255, 0));
}

} // namespace
} // namespace limen::gpu::test
