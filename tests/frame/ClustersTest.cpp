#include "SpheresInTwoSpaces.h"

#include "frame/Clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace limen::test {
namespace {

using frame::Cluster;
using frame::Clusters;

TEST(Clusters, listEachInstanceOfASpaceOnce) {
    for (const std::uint32_t count : {0u, 1u, 16u, 17u, 40u, 3000u}) {
        SCOPED_TRACE(count);
        const world::World world = spheresInTwoSpaces(count, count + 1);
        const Clusters clusters = frame::buildClusters(world);
        std::vector<int> seen(world.instances.size(), 0);
        for (const world::InstanceIndex instance : clusters.order)
            ++seen[instance];
        for (std::uint32_t i = 0; i < count; ++i)
            EXPECT_EQ(seen[i], world.instances[i].memberCount > 0 ? 1 : 0) << i;
        ASSERT_EQ(clusters.roots.size(), 2u);
        for (world::SpaceIndex space = 0; space < 2; ++space) {
            std::vector<world::InstanceIndex> listed;
            if (clusters.roots[space] != world::kNone) {
                const Cluster& root = clusters.clusters[clusters.roots[space]];
                EXPECT_LE(root.end, clusters.firstShared);
                for (std::uint32_t p = root.first; p < root.end; ++p)
                    listed.push_back(clusters.order[p]);
            }
            for (const std::uint32_t p : clusters.sharedIn(space)) {
                EXPECT_GE(p, clusters.firstShared);
                EXPECT_GT(world.instances[clusters.order[p]].memberCount, 1u);
                listed.push_back(clusters.order[p]);
            }
            std::sort(listed.begin(), listed.end());
            const world::Space& s = world.spaces[space];
            EXPECT_EQ(listed, std::vector(world.spaceInstances.begin() + s.firstInstance,
                                          world.spaceInstances.begin() + s.firstInstance + s.instanceCount));
        }
    }
}

TEST(Clusters, containTheSpheresOfTheirInstances_andAreDividedAmongChildren) {
    const world::World world = spheresInTwoSpaces(5000, 4);
    const Clusters clusters = frame::buildClusters(world);
    std::size_t leaves = 0;
    for (const Cluster& cluster : clusters.clusters) {
        ASSERT_LT(cluster.first, cluster.end);
        for (std::uint32_t p = cluster.first; p < cluster.end; ++p) {
            const Sphere& sphere = clusters.bounds[p];
            EXPECT_EQ(sphere.radius, world.instances[clusters.order[p]].bounds.radius);
            EXPECT_LE(glm::distance(sphere.centre, cluster.bounds.centre) + sphere.radius,
                      cluster.bounds.radius * (1 + 1e-12));
        }
        std::uint32_t next = cluster.first;
        for (std::uint32_t c = 0; c < cluster.childCount; ++c) {
            const Cluster& child = clusters.clusters[cluster.firstChild + c];
            EXPECT_EQ(child.first, next);
            next = child.end;
        }
        EXPECT_EQ(next, cluster.childCount > 0 ? cluster.end : cluster.first);
        EXPECT_EQ(cluster.childCount == 0, cluster.end - cluster.first <= frame::kLeafInstances);
        leaves += cluster.childCount == 0 ? 1 : 0;
    }
    EXPECT_LT(leaves, 1800u) << "a leaf holds several";
}

// The order of draws decides between equal depths, so it must not depend on the lists.
TEST(Clusters, doNotDependOnTheOrderOfTheLists) {
    world::World world = spheresInTwoSpaces(3000, 9);
    const Clusters before = frame::buildClusters(world);
    const auto second = world.spaceInstances.begin() + world.spaces[1].firstInstance;
    std::reverse(world.spaceInstances.begin(), second);
    const Clusters after = frame::buildClusters(world);
    EXPECT_TRUE(
        std::equal(before.order.begin(), before.order.begin() + before.firstShared, after.order.begin()));
}

TEST(Clusters, knowAtWhichDistancesTheirLevelsOfDetailAreDrawn) {
    const world::World world = spheresWithLevels(3000, 5);
    const Clusters clusters = frame::buildClusters(world);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> along(-300.0, 700.0), up(-50.0, 400.0);
    std::array<std::size_t, 3> found{};
    for (int view = 0; view < 60; ++view) {
        const world::LevelShare share{view % 2 == 0 ? 16u : 8u + view % 8u};
        const Vec3 eye(along(random), along(random), up(random));
        const world::RangeSteps steps = world::rangeStepsOf(eye);
        for (const Cluster& cluster : clusters.clusters) {
            const auto range = cluster.detail.at(cluster.bounds.centre - eye, share);
            ++found[static_cast<std::size_t>(range)];
            for (std::uint32_t p = cluster.first; p < cluster.end; ++p) {
                const bool isDrawn =
                    world::isInLevelRange(world, world.instances[clusters.order[p]], steps, share);
                ASSERT_TRUE(isDrawn || range != visibility::Containment::Inside);
                ASSERT_TRUE(!isDrawn || range != visibility::Containment::Outside);
            }
        }
    }
    const std::size_t all = found[0] + found[1] + found[2];
    EXPECT_GT(found[static_cast<std::size_t>(visibility::Containment::Outside)], all / 5);
    EXPECT_GT(found[static_cast<std::size_t>(visibility::Containment::Inside)], all / 5);
}

// Without levels the order is that of places alone.
TEST(Clusters, areDrawnAtEveryDistanceWithoutLevels) {
    const world::World world = spheresInTwoSpaces(300, 5);
    const Clusters clusters = frame::buildClusters(world);
    for (const Cluster& cluster : clusters.clusters)
        for (const double away : {0.0, 50.0, 1e6})
            EXPECT_EQ(cluster.detail.at({away, 0.0, away}, {8}), visibility::Containment::Inside);
    EXPECT_TRUE(frame::ClusterBatches(clusters).details.empty());
}

} // namespace
} // namespace limen::test
