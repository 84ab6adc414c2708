#include "GlFixture.h"

#include "reference/Scene.h"

#include <gmock/gmock.h>

namespace limen::gpu::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

// Expected sum of these polygons, in any order.
LayerSum sumOf(std::initializer_list<std::uint32_t> ids) {
    LayerSum sum;
    for (const std::uint32_t id : ids) {
        ++sum.count;
        sum.hash += reference::layerHash(id);
    }
    return sum;
}

// Room 1 around the eye, a wall 10 m north. Each pixel of a 2 x 2 picture shows a quarter of it.
class LayersGlTest : public GlTest {
protected:
    LayersGlTest() {
        scene_.root(1);
        scene_.addWall('A', {-10, -10}, {10, 10}, 10, {.members = {{1, 0}}});
        material_ = scene_.addMaterial({1, 0, 0, 0.5f}, layout::kNoTexture, layout::kMaterialAlpha);
    }
    // A transparent wall, of room 1 by default.
    void addPane(std::uint32_t id, glm::vec2 min, glm::vec2 max, float y, QuadOptions options = {{{1, 0}}}) {
        options.program = frame::Program::Blended;
        options.gated = true;
        options.material = options.material == 0 ? material_ : options.material;
        scene_.addWall(id, min, max, y, options);
    }
    std::vector<LayerSum> draw(std::uint32_t size = 2, Shading shading = Shading::IdsOnly) {
        Renderer renderer(*device_);
        EXPECT_TRUE(renderer.upload(scene_.upload));
        return renderWith(renderer, scene_.finish(), size, size, {.shading = shading, .wantLayers = true})
            .layers;
    }
    SceneBuilder scene_;
    std::uint32_t material_ = 0;
};

TEST_F(LayersGlTest, countsEachPolygonWhereItLies_topRowFirst) {
    addPane(7, {-1, -1}, {0, 1}, 1);       // the left half
    addPane(70000001, {-2, 0}, {2, 2}, 2); // the upper half
    EXPECT_THAT(draw(), ElementsAre(sumOf({7, 70000001}), sumOf({70000001}), sumOf({7}), sumOf({})));
}

TEST_F(LayersGlTest, hiddenOnesAreNotMet) {
    addPane(7, {-12, -12}, {12, 12}, 11); // behind the wall
    addPane(8, {-9, -9}, {9, 9}, 9);
    EXPECT_THAT(draw(), Each(sumOf({8})));
}

TEST_F(LayersGlTest, onesOfZonesThatNoRayVisitsAreNotMet) {
    addPane(7, {-1, -1}, {1, 1}, 1, {{{2, 0}}});
    EXPECT_THAT(draw(), Each(sumOf({})));
}

TEST_F(LayersGlTest, gatedByEntryPlane_onlyBeyondTheOpeningOfItsZone) {
    scene_.visitThrough({-5, -5}, {0, 5}, 5, 2, 0); // an opening 5 m north, left half, to room 2
    addPane(7, {-4, -4}, {4, 4}, 4, {{{2, 0}}});    // of room 2, but before the opening
    addPane(8, {-6, -6}, {6, 6}, 6, {{{2, 0}}});    // of room 2, seen through the opening only
    addPane(9, {-6, -6}, {6, 6}, 6);                // of room 1, beyond the opening: seen beside it only
    EXPECT_THAT(draw(), ElementsAre(sumOf({8}), sumOf({9}), sumOf({8}), sumOf({9})));
}

TEST_F(LayersGlTest, countedAtAnyBlendingAndAlpha) {
    const std::uint32_t flags[] = {layout::kMaterialAlpha, layout::kMaterialAdditive,
                                   layout::kMaterialInvAlpha};
    std::uint32_t id = 100;
    for (const std::uint32_t flag : flags) {
        for (const float alpha : {0.0f, 0.3f, 1.0f}) {
            QuadOptions options{.members = {{1, 0}}};
            options.material = scene_.addMaterial({1, 1, 1, alpha}, layout::kNoTexture, flag);
            addPane(id++, {-1, -1}, {1, 1}, 1, options);
        }
    }
    EXPECT_THAT(draw(), Each(sumOf({100, 101, 102, 103, 104, 105, 106, 107, 108})));
}

TEST_F(LayersGlTest, trianglesOfAPolygonMeetWithoutOverlapOrGap) {
    addPane(7, {-3, -3}, {3, 3}, 3); // two triangles that share a diagonal through pixel centres
    EXPECT_THAT(draw(48), Each(sumOf({7})));
}

TEST_F(LayersGlTest, twoHundredLayersAreExact) {
    LayerSum all;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const std::uint32_t id = 0xFFFF0000u + i * 77u;
        addPane(id, {-1, -1}, {1, 1}, 1);
        all = {all.count + 1, all.hash + reference::layerHash(id)};
    }
    EXPECT_THAT(draw(), Each(all));
}

TEST_F(LayersGlTest, countedTheSameUnderEveryShading_andNoneIsLeftFromTheFrameBefore) {
    addPane(7, {-1, -1}, {0, 1}, 1);
    const std::vector<LayerSum> ids = draw();
    EXPECT_EQ(draw(2, Shading::Lit), ids);
    EXPECT_EQ(draw(2, Shading::FlatIds), ids);
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene_.upload));
    Result<RenderTarget> target = RenderTarget::create(*device_, 2, 2, {.layers = true});
    ASSERT_TRUE(target);
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(renderer.render(scene_.finish(), *target, {.wantLayers = true}));
        EXPECT_EQ(target->readLayers(), ids);
    }
}

} // namespace
} // namespace limen::gpu::test
