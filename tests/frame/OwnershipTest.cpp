#include "PlannedWorld.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

bool keeps(const frame::gpu::ClipSet& clip, const Vec3f& p) {
    return std::all_of(std::begin(clip.planes), std::end(clip.planes), [&](const frame::gpu::vec4& plane) {
        return glm::dot(plane, frame::gpu::vec4(p, 1.0f)) >= 0.0f;
    });
}

struct OwnershipTest : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    world::SpaceIndex first = world::findCell(planned.world, rooms.world.id(rooms.first));
};

TEST_F(OwnershipTest, drawsAPortalFromTheVeryFloatsOfItsWalls) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    const world::Portal& portal = planned.world.portals[planned.visible.visits[1].portal];
    const auto outline =
        std::span(planned.world.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
    std::size_t corners = 0;
    for (const auto& vertex : plan.ownershipVertices) {
        if (vertex.visit != 1)
            continue;
        EXPECT_EQ(vertex.block, portal.block);
        for (const Vec3& v : outline) {
            const TwoFloats parts = inTwoFloats(v - planned.world.blocks[portal.block].origin());
            corners += parts.nearest == vertex.position && parts.rest == vertex.rest ? 1 : 0;
        }
    }
    EXPECT_EQ(corners, 2 * outline.size()) << "a fan around the middle meets each corner twice";
}

TEST_F(OwnershipTest, followsTheTreesOrder) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    std::uint32_t last = 1;
    for (const auto& vertex : plan.ownershipVertices) {
        EXPECT_GE(vertex.visit, last);
        last = vertex.visit;
    }
    EXPECT_EQ(last, planned.visible.visits.size() - 1);
}

TEST_F(OwnershipTest, clipsByTheParentsEdgesAndNeverByTheRoots) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    for (const auto& vertex : plan.ownershipVertices) {
        const auto& visit = planned.visible.visits[vertex.visit];
        EXPECT_EQ(vertex.clipSet == 0, visit.depth == 1) << "the screen's edges need no clipping";
    }
    // A point in the middle of the grandchild's opening is kept; one beside the parent's opening is clipped.
    const auto& clip = plan.clipSets[1];
    EXPECT_TRUE(keeps(clip, {0, 7, -0.5f}));
    EXPECT_FALSE(keeps(clip, {4, 7, -0.5f}));
    EXPECT_TRUE(keeps(clip, {0, 2, -0.5f})) << "the opening is beyond the entry plane, so that does not clip";
}

TEST(Ownership, clipsByTheParentsEntryPlaneWhatReachesBeforeIt) {
    TestWorld world;
    const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    const auto b = world.addBox({0, 2, 0}, {4, 8, 3}, "blue");
    const auto c = world.addBox({4, 2, 0}, {8, 8, 3}, "red");
    world.link(a, rectangle({0.5, 4, 0}, {3.9, 4, 2.5}), b);
    world.link(b, rectangle({4, 3, 0}, {4, 5, 2}), c);
    PlannedWorld planned(world);
    const auto& plan = planned.planFrom({1, 1, 1.5}, 40, world::findCell(planned.world, world.id(a)));
    ASSERT_EQ(planned.visible.visits.size(), 3u);
    EXPECT_TRUE(keeps(plan.clipSets[1], {2.8f, 3.3f, -0.5f}));
    EXPECT_FALSE(keeps(plan.clipSets[1], {2.4f, 2.9f, -0.5f})) << "before the parent's entry plane";
}

TEST_F(OwnershipTest, looksForAnOpeningInTheWholeWindowWithinFiveCentimetresOfIt) {
    for (const double before : {0.0005, 0.03, 0.08}) {
        const auto& plan = planned.planFrom({92, 94.0 - before, 1.5}, 0, first);
        ASSERT_FALSE(plan.ownershipVertices.empty());
        for (const auto& vertex : plan.ownershipVertices) {
            const bool everywhere = (vertex.outlineCount & frame::gpu::kCoverWindow) != 0;
            EXPECT_EQ(everywhere, vertex.visit == 1 && before < 0.05) << before;
        }
    }
}

TEST_F(OwnershipTest, drawsAnOpeningNearTheEyeAsItsRegionIfCoverageDecides) {
    planned.coverageDecides = true;
    for (const double before : {0.0, 0.0005, 0.03, 0.08}) {
        const auto& plan = planned.planFrom({92, 94.0 - before, 1.5}, 0, first);
        const auto& visit = planned.visible.visits[1];
        const auto region = planned.visible.region(visit);
        std::size_t corners = 0;
        for (const auto& vertex : plan.ownershipVertices) {
            EXPECT_EQ(vertex.outlineCount & frame::gpu::kCoverWindow, 0u) << "no fragment tests edges";
            const bool onScreen = (vertex.outlineCount & frame::gpu::kOnScreen) != 0;
            EXPECT_EQ(onScreen, vertex.visit == 1 && before < 0.05) << before;
            corners += onScreen && std::any_of(region.begin(), region.end(), [&](const Vec3& corner) {
                           return Vec3f(corner) == vertex.position;
                       });
            EXPECT_TRUE(!onScreen || vertex.clipSet == 0);
        }
        EXPECT_EQ(corners, before < 0.05 ? 3 * (region.size() - 2) : 0) << "a fan of the region";
    }
}

TEST_F(OwnershipTest, trianglesAreCounterClockwiseIfCoverageDecides) {
    planned.coverageDecides = true;
    std::size_t triangles = 0, turned = 0;
    for (const double aside : {-1.3, 0.0, 1.3}) {
        for (const double yaw : {-60.0, 0.0, 40.0}) { // some corners are behind the eye
            const auto& plan = planned.planFrom({92 + aside, 93.9, 1.5}, yaw, first);
            const Mat3 screen = planned.view.view.screenFromEye();
            const auto at = [&](std::size_t i) {
                const auto& vertex = plan.ownershipVertices[i];
                const Vec3 position(vertex.position);
                return (vertex.outlineCount & frame::gpu::kOnScreen) != 0
                           ? position
                           : screen * (position + Vec3(vertex.rest) +
                                       planned.world.blocks[vertex.block].origin() - planned.view.view.eye);
            };
            for (std::size_t i = 0; i + 2 < plan.ownershipVertices.size(); i += 3, ++triangles)
                turned += glm::dot(at(i), glm::cross(at(i + 1), at(i + 2))) < 0.0 ? 1 : 0;
        }
    }
    EXPECT_GT(triangles, 20u);
    EXPECT_EQ(turned, 0u) << "of " << triangles;
}

TEST_F(OwnershipTest, testsOnlyEdgesThatCutTheOpeningIfCoverageDecides) {
    std::size_t all = 0, used = 0;
    for (const double aside : {0.0, 0.3, 0.8, 1.3}) {
        const Vec3 eye{92 + aside, 91, 1.5};
        const frame::FramePlan exact = planned.planFrom(eye, 10, first);
        planned.coverageDecides = true;
        const frame::FramePlan& plan = planned.planFrom(eye, 10, first);
        planned.coverageDecides = false;
        ASSERT_EQ(plan.ownershipVertices.size(), exact.ownershipVertices.size());
        for (std::size_t i = 0; i + 2 < plan.ownershipVertices.size(); i += 3) {
            const auto &vertex = plan.ownershipVertices[i], &before = exact.ownershipVertices[i];
            all += before.clipEdges;
            used += vertex.clipEdges;
            const auto& clip = plan.clipSets[vertex.clipSet];
            for (std::size_t e = vertex.clipEdges; e < frame::gpu::kLastClipPlane; ++e)
                EXPECT_EQ(clip.planes[e], frame::gpu::vec4(0, 0, 0, 1)) << "behind those in use";
            const world::Portal& portal = planned.world.portals[planned.visible.visits[vertex.visit].portal];
            const std::span<const Vec3> polygon = world::polygonOf(planned.world, portal);
            for (std::size_t c = 0; c < polygon.size(); ++c) {
                for (double share = 0.0; share < 1.0; share += 0.01) {
                    const Vec3f at(glm::mix(polygon[c], polygon[(c + 1) % polygon.size()], share) -
                                   planned.view.view.eye);
                    EXPECT_EQ(keeps(clip, at), keeps(exact.clipSets[before.clipSet], at))
                        << c << " " << share;
                }
            }
        }
    }
    EXPECT_LT(used, all);
    EXPECT_GT(used, 4u) << "some openings are cut";
}

TEST(Ownership, cutsAnInexactPairByTheOtherPolygonAndDrawsItsHoleWhole) {
    TestWorld world;
    const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
    TestWorld::LinkOptions link;
    link.exact = false;
    link.polygonInB = rectangle({1, 4, 0}, {2.5, 4, 2});
    world.link(a, rectangle({1.5, 4, 0}, {3, 4, 2}), b, link);
    PlannedWorld planned(world);
    const auto& plan = planned.planFrom({2, 1, 1.5}, 0, world::findCell(planned.world, world.id(a)));
    ASSERT_EQ(planned.visible.visits.size(), 3u);
    EXPECT_EQ(plan.visits[1].zone, visibility::kNoZone);
    for (const auto& vertex : plan.ownershipVertices) {
        EXPECT_NE(vertex.block, frame::gpu::kNoVisit) << "from the corners that the walls have";
        EXPECT_EQ(vertex.clipSet, vertex.visit - 1);
    }
    EXPECT_TRUE(keeps(plan.clipSets[1], {0.4f, 3, -0.5f}));
    EXPECT_FALSE(keeps(plan.clipSets[1], {0.6f, 3, -0.5f}))
        << "the reciprocal ends half a metre right of the eye";
}

TEST(Ownership, cutsARegionOfManyEdgesIntoSeveralDraws) {
    TestWorld world;
    const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
    const auto c = world.addBox({0, 8, 0}, {4, 12, 3}, "red");
    world.link(a, regularPolygon({2, 4, 1.5}, {0, -1, 0}, 0.5, 12), b);
    world.link(b, regularPolygon({2, 8, 1.5}, {0, -1, 0}, 1.4, 12), c);
    PlannedWorld planned(world);
    const auto& plan = planned.planFrom({2, 1, 1.5}, 0, world::findCell(planned.world, world.id(a)));
    ASSERT_EQ(planned.visible.visits.size(), 3u);
    EXPECT_EQ(planned.visible.region(planned.visible.visits[1]).size(), 12u);
    EXPECT_EQ(plan.clipSets.size(), 3u) << "the open set, and two fans of at most seven edges";
}

} // namespace
} // namespace limen::test
