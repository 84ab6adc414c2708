#include "GlFixture.h"
#include "IsColour.h"

#include <gmock/gmock.h>

namespace limen::gpu::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

class SkyGlTest : public GlTest {
protected:
    static SceneBuilder openAir() {
        SceneBuilder scene;
        scene.root(0);
        scene.plan.constants.fogColour = {1, 0, 0, 1};
        scene.plan.constants.skyZenith = {0, 0, 1, 1};
        return scene;
    }
};

TEST_F(SkyGlTest, sky_onlyWhereTheRayGotOutside) {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-1, -1}, {1, 1}, 2, 0, 0);    // a window
    scene.visitThrough({-0.8f, -1}, {0, 1}, 3, 2, 1); // a door of another house, which has a hole
    scene.addWall('A', {-2, -2}, {2, -1}, 2, {.members = {{1, 0}}, .gated = true});
    // The rest of the room has no wall: void, not sky.
    EXPECT_THAT(render(scene).picture(), ElementsAre("........", "........", "..~~~~..", "..~.~~..",
                                                     "..~.~~..", "..~~~~..", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(SkyGlTest, plainSky_runsFromFogAtTheHorizonToTheZenith) {
    SceneBuilder scene = openAir();
    const Frame frame = render(scene, 4);
    EXPECT_THAT(frame.ids, Each(layout::kSkyId));
    EXPECT_THAT(frame.depth, Each(0.0f));
    EXPECT_EQ(frame.at(0, 3), glm::ivec3(255, 0, 0)) << "below the horizon";
    EXPECT_GT(frame.at(1, 0).z, frame.at(1, 1).z);
    EXPECT_LT(frame.at(1, 0).x, frame.at(1, 1).x);
}

TEST_F(SkyGlTest, skyObjects_blendOverThePlainSkyAndKeepItsId) {
    SceneBuilder scene = openAir();
    scene.addSky({-1, -1}, {0, 1}, 1, scene.addMaterial({0, 1, 0, 1}), 1.0f);
    scene.addSky({0, -1}, {1, 1}, 1,
                 scene.addMaterial({0, 1, 0, 1}, layout::kNoTexture, layout::kMaterialAdditive), 0.5f);
    const Frame frame = render(scene, 2);
    EXPECT_THAT(frame.picture(), ElementsAre("~~", "~~"));
    EXPECT_THAT(frame.depth, Each(0.0f));
    EXPECT_EQ(frame.at(0, 1), glm::ivec3(0, 255, 0));
    EXPECT_THAT(frame.at(1, 1), IsColour(255, 128, 0)) << "additive";
}

TEST_F(SkyGlTest, skyObjects_lieBehindEverythingAndOnlyOutside) {
    SceneBuilder scene;
    scene.root(1);
    scene.plan.constants.voidColour = {0, 0, 0, 1};
    scene.visitThrough({0, -2}, {2, 2}, 2, 0, 0);
    scene.addSky({-1, -1}, {1, 1}, 0.5f, scene.addMaterial({0, 1, 0, 1}), 1.0f);
    scene.addWall('A', {-5000, -5000}, {5000, 0}, 5000, {.members = {{0, 0}}, .gated = true});
    const Frame frame = render(scene, 4);
    EXPECT_THAT(frame.picture(), ElementsAre("..~~", "..~~", "..AA", "..AA"));
    EXPECT_EQ(frame.at(3, 0), glm::ivec3(0, 255, 0));
    EXPECT_EQ(frame.at(3, 3), glm::ivec3(255));
    EXPECT_EQ(frame.at(0, 0), glm::ivec3(0));
}

TEST_F(SkyGlTest, skyObjects_areLitAsObjectsOutdoors) {
    SceneBuilder scene = openAir();
    scene.plan.constants.skyAmbient = {0.2f, 0, 0, 0};
    scene.plan.constants.sunColour = {0, 0.8f, 0, 0};
    scene.plan.constants.sunDirection = {0, -1, 0, 0}; // onto the front
    const std::uint32_t white = scene.addMaterial({1, 1, 1, 1});
    const std::uint32_t shining = scene.addMaterial({1, 1, 1, 1});
    scene.upload.materials.back().luminosity = 0.2f;
    for (const auto& [x, material] : {std::pair{-1.0f, white}, {0.0f, shining}}) {
        layout::SkyInstance& object = scene.addSky({x, -1}, {x + 1, 1}, 1, material, 1.0f);
        object.luminosity = 0.4f;
        object.diffuse = 0.5f;
    }
    const Frame frame = render(scene, 2);
    EXPECT_EQ(frame.at(0, 0), glm::ivec3(153, 204, 102));
    EXPECT_EQ(frame.at(1, 0), glm::ivec3(102, 153, 51)) << "the material's luminosity replaces the object's";
}

TEST_F(SkyGlTest, weather_coversEverythingOutdoors) {
    SceneBuilder scene;
    scene.root(0);
    scene.plan.constants.voidColour = {0, 0, 0, 1};
    scene.visitThrough({0, -2}, {2, 2}, 2, 1, 0); // a house on the right
    scene.addWall('A', {-1, -1}, {0, 1}, 0.5f, {.members = {{0, 0}}});
    scene.addWall('B', {0, -9}, {9, 9}, 3, {.members = {{1, 0}}, .gated = true});
    scene.addSky({-1, -1}, {1, 1}, 1, scene.addMaterial({0, 1, 0, 1}), 0.5f).overLand = 1;
    const Frame frame = render(scene, 4);
    EXPECT_THAT(frame.picture(), ElementsAre("AABB", "AABB", "AABB", "AABB"));
    EXPECT_NEAR(frame.at(0, 0).x, 127.5, 1) << "before it";
    EXPECT_EQ(frame.at(0, 0).y, 255);
    EXPECT_EQ(frame.at(3, 0), glm::ivec3(255)) << "not in the house";
    EXPECT_LT(frame.depth[0], 1.0f) << "weather has no depth";
}

} // namespace
} // namespace limen::gpu::test
