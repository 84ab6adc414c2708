#include "GlFixture.h"

#include <bit>

namespace limen::gpu::test {
namespace {

// A white wall 2 m north, lit by light set 1. Colours have 8 bits.
class LightingGlTest : public GlTest {
protected:
    static SceneBuilder wallLitBy(const layout::LightSet& set, std::uint32_t zone = 1,
                                  std::uint32_t material = 0) {
        SceneBuilder scene;
        scene.root(zone);
        scene.upload.lightSets.push_back(set);
        scene.addWall('A', {-2, -2}, {2, 2}, 2, {.members = {{zone, 1}}, .material = material});
        return scene;
    }
};

TEST_F(LightingGlTest, ambientAndItsShareOfTheSky) {
    layout::LightSet set;
    set.ambient = {0.2f, 0, 0.4f, 0.5f};
    SceneBuilder scene = wallLitBy(set);
    scene.plan.constants.skyAmbient = {0, 0.8f, 0.4f, 0};
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(51, 102, 153));
}

TEST_F(LightingGlTest, sunByItsShareAndTheAngle) {
    layout::LightSet set;
    set.sun = 0.5f;
    SceneBuilder scene = wallLitBy(set);
    scene.plan.constants.sunColour = {1, 0.5f, 0, 0};
    scene.plan.constants.sunDirection = {0.6f, -0.8f, 0, 0};
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(102, 51, 0));
    scene.plan.constants.sunDirection = {0, 1, 0, 0}; // behind the wall
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(0));
}

TEST_F(LightingGlTest, lampFallsOffToNothingAtItsRange) {
    layout::LightSet set;
    set.lightCount = 1;
    SceneBuilder scene = wallLitBy(set);
    layout::Light lamp;
    lamp.position = {0, 1, 0, 2}; // 1 m before the wall's middle
    lamp.colour = {1, 1, 1, std::bit_cast<float>(0u)};
    scene.upload.lights.push_back(lamp);
    const Frame frame = render(scene, 9);
    // In the middle facing is 1, so the light is (1 - (1/2)^2)^2.
    EXPECT_NEAR(frame.at(4, 4).x, 0.5625 * 255, 1);
    EXPECT_LT(frame.at(6, 4).x, frame.at(5, 4).x);
    EXPECT_EQ(frame.at(0, 0), glm::ivec3(0)) << "more than 2 m away";
}

TEST_F(LightingGlTest, lampOfAnotherBlockStandsInThatBlock) {
    layout::LightSet set;
    set.lightCount = 1;
    SceneBuilder scene = wallLitBy(set);
    scene.plan.blocks.push_back({-192, 0, 0, 0});
    layout::Light lamp;
    lamp.position = {192, 1, 0, 2};
    lamp.colour = {1, 1, 1, std::bit_cast<float>(1u)};
    scene.upload.lights.push_back(lamp);
    EXPECT_NEAR(render(scene, 9).at(4, 4).x, 0.5625 * 255, 1);
}

TEST_F(LightingGlTest, luminosityIsTheLeastLight) {
    SceneBuilder scene = wallLitBy({}, 1, 1);
    scene.addMaterial({1, 0.5f, 0, 1});
    scene.upload.materials.back().luminosity = 0.4f;
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(102, 51, 0));
}

TEST_F(LightingGlTest, fogIsOutsideOnly) {
    for (const std::uint32_t zone : {0u, 1u}) {
        layout::LightSet set;
        set.ambient = {1, 1, 1, 0};
        SceneBuilder scene = wallLitBy(set, zone);
        scene.plan.constants.fogColour = {1, 0, 0, 1};
        scene.plan.constants.fogRange = {1, 3, 0, 0};
        const Frame frame = render(scene, 9); // the middle pixel is 2 m away: half fog
        EXPECT_EQ(frame.at(4, 4), zone == 0 ? glm::ivec3(255, 128, 128) : glm::ivec3(255));
    }
}

TEST_F(LightingGlTest, highlightCoversByItsAlpha) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-2, -2}, {2, 2}, 2, {.highlight = 0xFF00FF00u}); // A,B,G,R: green, full strength
    EXPECT_EQ(render(scene, 2).at(0, 0), glm::ivec3(0, 255, 0));
}

} // namespace
} // namespace limen::gpu::test
