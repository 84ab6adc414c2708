#include "GlFixture.h"
#include "IsColour.h"

#include <gmock/gmock.h>

namespace limen::gpu::test {
namespace {

using ::testing::ElementsAre;

class OwnershipGlTest : public GlTest {
protected:
    static constexpr std::uint32_t kRoom = 1, kNext = 2;

    static QuadOptions in(std::vector<layout::Member> members, bool gated = true) {
        QuadOptions options;
        options.members = std::move(members);
        options.gated = gated;
        return options;
    }
    // The eye's room with a wall 2 m north, an opening of 2 m x 2 m in it (the middle 4 x 4 of 8 x 8 pixels),
    // and the next room's far wall 4 m north.
    static SceneBuilder twoRooms() {
        SceneBuilder scene;
        scene.root(kRoom);
        scene.visitThrough({-1, -1}, {1, 1}, 2, kNext, 0);
        scene.addWallWithOpening('A', 2, 1, 2, in({{kRoom, 0}}));
        scene.addWall('B', {-8, -8}, {8, 8}, 4, in({{kNext, 0}}));
        return scene;
    }
};

TEST_F(OwnershipGlTest, opening_showsTheNextRoomAndOnlyInside) {
    SceneBuilder scene = twoRooms();
    const Frame frame = render(scene);
    EXPECT_THAT(frame.picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AABBBBAA", "AABBBBAA", "AABBBBAA",
                                             "AABBBBAA", "AAAAAAAA", "AAAAAAAA"));
    EXPECT_EQ(frame.ownership[0], 0u);
    EXPECT_EQ(frame.ownership[3 * 8 + 3], 1u);
}

TEST_F(OwnershipGlTest, nothingOfTheNextRoomShowsBeforeItsEntryPlane) {
    SceneBuilder scene = twoRooms();
    scene.addWall('C', {-0.5f, -1}, {1, 1}, 1, in({{kNext, 0}})); // 1 m before the opening
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AABBBBAA", "AABBBBAA",
                                                     "AABBBBAA", "AABBBBAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, nothingOfTheEyesRoomShowsBeyondTheOpening) {
    SceneBuilder scene = twoRooms();
    scene.addWall('D', {-8, -8}, {0, 8}, 3, in({{kRoom, 0}})); // intersects the next room
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AABBBBAA", "AABBBBAA",
                                                     "AABBBBAA", "AABBBBAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, memberOfBothRoomsIsSeenWhole) {
    SceneBuilder scene = twoRooms();
    // A floor strip from 1 m before to 1.5 m behind the opening, at z = -0.4, 1.2 m wide, seen from above.
    // The rows at z/y = -0.125 and -0.375 hit it at y = 3.2, where it is 3 eighths of the picture wide, and
    // at y = 1.07.
    scene.addQuad('M',
                  {glm::vec3{-0.6f, 1, -0.4f}, {0.6f, 1, -0.4f}, {0.6f, 3.5f, -0.4f}, {-0.6f, 3.5f, -0.4f}},
                  in({{kRoom, 0}, {kNext, 0}}));
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AABBBBAA", "AABBBBAA",
                                                     "AABMMBAA", "AAMMMMAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, memberThatStandsInTheOpeningIsSeenOnBothSides) {
    SceneBuilder scene = twoRooms();
    scene.addWall('N', {-0.5f, -0.5f}, {0, 0.5f}, 1,
                  in({{kRoom, 0}, {kNext, 0}})); // before: 2 columns of pixels
    scene.addWall('F', {0, -0.75f}, {0.75f, 0.75f}, 3, in({{kRoom, 0}, {kNext, 0}})); // behind: 1 column
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AANNBBAA", "AANNFBAA",
                                                     "AANNFBAA", "AANNBBAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, surfacesInThePortalsPlaneBelongToBothSides) {
    SceneBuilder scene = twoRooms();
    scene.addWall('P', {-1, -1}, {0, 1}, 2, in({{kRoom, 0}})); // half of the opening is filled from this side
    scene.addWall('Q', {0.5f, -1}, {1, 1}, 2, in({{kNext, 0}}));
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AAPPBQAA", "AAPPBQAA",
                                                     "AAPPBQAA", "AAPPBQAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, chainOfThreeZonesEndsAtItsLastRoom) {
    SceneBuilder scene;
    scene.root(1);
    const std::uint32_t second = scene.visitThrough({-1, -1}, {1, 1}, 2, 2, 0);
    scene.visitThrough({-1, -1}, {1, 1}, 4, 1, second); // back into the eye's zone, which is elsewhere
    scene.addWallWithOpening('A', 8, 1, 2, in({{1, 0}}));
    scene.addWallWithOpening('B', 8, 1, 4, in({{2, 0}}));
    scene.addWall('C', {-8, -8}, {8, 8}, 6, in({{1, 0}}));
    // of zone 1, but between the openings: no ray hits it
    scene.addWall('D', {-8, -8}, {8, 8}, 3, in({{1, 0}}));
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AABBBBAA", "AABCCBAA",
                                                     "AABCCBAA", "AABBBBAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, clipSetLimitsAChildsPixels) {
    SceneBuilder scene = twoRooms();
    layout::ClipSet set = scene.plan.clipSets[0];
    set.planes[0] = {1, 0, 0, 0};  // x >= 0
    set.planes[7] = {0, 0, -1, 0}; // z <= 0
    scene.plan.clipSets.push_back(set);
    for (layout::OwnershipVertex& vertex : scene.plan.ownershipVertices)
        vertex.clipSet = 1;
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AA....AA", "AA....AA",
                                                     "AA..BBAA", "AA..BBAA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, aClipSetAloneOwnsItsPixels) {
    SceneBuilder scene = twoRooms();
    layout::ClipSet set = scene.plan.clipSets[0]; // the opening's left half, at any distance
    set.planes[0] = {-1, 0, 0, 0};
    set.planes[1] = {1, 0.5f, 0, 0};
    set.planes[2] = {0, 0.5f, -1, 0};
    set.planes[3] = {0, 0.5f, 1, 0};
    scene.plan.clipSets.push_back(set);
    layout::OwnershipVertex vertex;
    vertex.visit = 1;
    vertex.clipSet = 1;
    vertex.outlineCount = layout::kCoverWindow;
    scene.plan.ownershipVertices.assign(3, vertex);
    EXPECT_THAT(render(scene).picture(), ElementsAre("AAAAAAAA", "AAAAAAAA", "AABB..AA", "AABB..AA",
                                                     "AABB..AA", "AABB..AA", "AAAAAAAA", "AAAAAAAA"));
}

TEST_F(OwnershipGlTest, openingDrawnAroundTheWholeWindowOwnsTheSamePixels) {
    SceneBuilder scene = twoRooms();
    const Frame drawn = render(scene);
    for (layout::OwnershipVertex& vertex : scene.plan.ownershipVertices)
        vertex.outlineCount |= layout::kCoverWindow;
    EXPECT_EQ(render(scene).ids, drawn.ids);
    EXPECT_EQ(render(scene, 8, {.exactOutlines = false}).ids, drawn.ids);
}

TEST_F(OwnershipGlTest, portalAcrossTheEyesPlaneOwnsThePartInFront) {
    SceneBuilder scene;
    scene.root(1);
    // A trapdoor's plane just below the eye, from 5 m behind to 5 m before it; everything below belongs to
    // zone 2.
    layout::Visit below;
    below.entryPlane = {0, 0, -1, -0.001f};
    below.zone = 2;
    scene.plan.visits.push_back(below);
    scene.addOpening(std::array{glm::vec3{-50, -5, -0.001f}, glm::vec3{50, -5, -0.001f},
                                glm::vec3{50, 500, -0.001f}, glm::vec3{-50, 500, -0.001f}},
                     1);
    scene.addWall('B', {-8, -8}, {8, 8}, 4, in({{2, 0}}));
    EXPECT_THAT(render(scene, 4).picture(), ElementsAre("....", "....", "BBBB", "BBBB"));
}

TEST_F(OwnershipGlTest, ungatedEqualsGatedWithOneVisit) {
    const auto draw = [this](bool gated) {
        SceneBuilder scene;
        scene.root(kRoom);
        scene.addWall('A', {-2, -2}, {1, 2}, 2, in({{0, 0}, {kRoom, 0}}, gated));
        scene.addWall('B', {-3, -1}, {3, 3}, 3, in({{kRoom, 0}}, gated));
        return render(scene, 16);
    };
    const Frame gated = draw(true);
    const Frame ungated = draw(false);
    EXPECT_EQ(gated.ids, ungated.ids);
    EXPECT_EQ(gated.colour, ungated.colour);
    EXPECT_EQ(gated.depth, ungated.depth);
}

TEST_F(OwnershipGlTest, memberOfTwoZonesIsLitByTheRootsIfThatIsOneOfThem) {
    const auto draw = [this](bool gated) {
        SceneBuilder scene = twoRooms();
        scene.plan.constants.sealedAmbient = {0.5f, 0.25f, 0, 0};
        scene.upload.lightSets.push_back({layout::kLitThing, 0, 0, 1});
        scene.addWall('F', {-0.75f, -0.75f}, {0.75f, 0.75f}, 3, in({{kRoom, 1}, {kNext, 0}}, gated));
        scene.addWall('N', {-0.12f, -0.12f}, {0.12f, 0.12f}, 1, in({{kNext, 0}, {kRoom, 1}}, gated));
        return render(scene, 16);
    };
    const Frame gated = draw(true);
    const Frame ungated = draw(false);
    EXPECT_EQ(gated.ids, ungated.ids);
    EXPECT_EQ(gated.colour, ungated.colour);
    EXPECT_THAT(gated.at(6, 6), IsColour(128, 64, 0));
    EXPECT_THAT(gated.at(7, 7), IsColour(128, 64, 0));
}

} // namespace
} // namespace limen::gpu::test
