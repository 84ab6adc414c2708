#include "GlFixture.h"

#include "frame/IdColour.h"

namespace limen::gpu::test {
namespace {

// A wall with a transparent hole, landscape below, an opening to the outside above, void at the sides.
SceneBuilder mixedScene() {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-2, 0.3f}, {2, 2}, 2, layout::kOutside, 0);
    const std::uint32_t texture = scene.addTexture(2, 1, {255, 255, 255, 255, 0, 0, 0, 0});
    const std::uint32_t material = scene.addMaterial({1, 1, 1, 1}, texture);
    scene.addWall(
        70001, {-0.8f, -0.9f}, {0.9f, 0.7f}, 1,
        {.members = {{1, 0}}, .material = material, .program = frame::Program::CutOut, .gated = true});
    scene.addWall(123456789, {-2, -2}, {1.5f, 0.3f}, 2, {.members = {{1, 0}}, .gated = true});
    scene.upload.terrainCells.resize(1);
    scene.upload.terrainCells[0].base = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
    for (layout::TerrainLayer* layer :
         {scene.upload.terrainCells[0].overlays, scene.upload.terrainCells[0].roads})
        layer[0].texture = layer[1].texture = layout::kNoTexture;
    scene.upload.terrainCells[0].overlays[2].texture = layout::kNoTexture;
    scene.addWall(4, {-3, 0}, {3, 1}, 3,
                  {.members = {{0, 0}}, .program = frame::Program::Terrain, .gated = true});
    scene.addWall(9, {-1, -1}, {0, 1}, 0.5f,
                  {.members = {{1, 0}},
                   .material = scene.addMaterial({0, 1, 0, 0.5f}),
                   .program = frame::Program::Blended,
                   .gated = true});
    scene.addSky({-1, -1}, {1, 1}, 1, 0, 0.5f);
    return scene;
}

class FlatGlTest : public GlTest {
protected:
    Frame draw(Shading shading, bool exactCutOuts) {
        SceneBuilder scene = mixedScene();
        scene.plan.constants.flags = exactCutOuts ? layout::kFrameExactCutOuts : 0u;
        Renderer renderer(*device_);
        EXPECT_TRUE(renderer.upload(scene.upload));
        return renderWith(renderer, scene.finish(), 64, 64, {.shading = shading});
    }
};

TEST_F(FlatGlTest, idsAndDepthAreThoseOfALitFrame) {
    const Frame lit = draw(Shading::Lit, true);
    for (const bool exact : {false, true}) { // flat frames have exact cut-outs in any case
        for (const Shading shading : {Shading::FlatIds, Shading::IdsOnly}) {
            const Frame flat = draw(shading, exact);
            EXPECT_EQ(flat.ids, lit.ids);
            EXPECT_EQ(flat.depth, lit.depth);
        }
        for (const std::uint32_t id : {0u, 1u, 4u, 70001u, 123456789u})
            EXPECT_GT(std::count(lit.ids.begin(), lit.ids.end(), id), 0) << id << " is in the picture";
    }
}

TEST_F(FlatGlTest, everyPixelHasTheColourOfItsId) {
    const Frame flat = draw(Shading::FlatIds, true);
    for (std::uint32_t i = 0; i < flat.ids.size(); ++i) {
        const auto [r, g, b] = frame::colourOfId(flat.ids[i]);
        ASSERT_EQ(flat.at(i % 64, i / 64), glm::ivec3(r, g, b)) << "pixel " << i << ", id " << flat.ids[i];
    }
}

TEST_F(FlatGlTest, coloursOfNeighbouringIdsAreFarApart) {
    for (std::uint32_t id = 0; id < 5000; ++id) {
        const auto a = frame::colourOfId(id), b = frame::colourOfId(id + 1);
        int apart = 0;
        for (std::size_t i = 0; i < 3; ++i)
            apart = std::max(apart, std::abs(int{a[i]} - int{b[i]}));
        EXPECT_GE(apart, 4) << id;
    }
}

} // namespace
} // namespace limen::gpu::test
