#include "frame/Clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace limen::test {
namespace {

using frame::Cluster;
using frame::Clusters;

/// Two spaces with balls of all sizes; every ninth is in both, every eleventh in none.
world::World ballsInTwoSpaces(std::uint32_t count, std::uint32_t seed) {
    world::World world;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::array<std::vector<world::InstanceIndex>, 2> lists;
    for (std::uint32_t i = 0; i < count; ++i) {
        world::Instance instance;
        instance.bounds = {Vec3(unit(random), unit(random), 0.1 * unit(random)) * 400.0,
                           std::exp(8.0 * unit(random) - 3.0)};
        if (i % 5 == 0)
            instance.bounds.centre = {7.0, 7.0, 7.0}; // many in one place
        instance.firstMember = static_cast<std::uint32_t>(world.members.size());
        const auto join = [&](std::uint32_t space) {
            world.members.push_back(space);
            lists[space].push_back(i);
            ++instance.memberCount;
        };
        if (i % 9 == 0) {
            join(1);
            join(0);
        } else if (i % 11 != 0) {
            join(i % 2);
        }
        world.instances.push_back(instance);
    }
    for (const auto& list : lists) {
        world::Space space;
        space.firstInstance = static_cast<std::uint32_t>(world.spaceInstances.size());
        space.instanceCount = static_cast<std::uint32_t>(list.size());
        space.zone = static_cast<std::uint32_t>(world.spaces.size());
        world.spaces.push_back(space);
        world.spaceInstances.insert(world.spaceInstances.end(), list.begin(), list.end());
    }
    return world;
}

TEST(Clusters, listEachInstanceOfASpaceOnceAndInItsPlace) {
    for (const std::uint32_t count : {0u, 1u, 16u, 17u, 40u, 3000u}) {
        SCOPED_TRACE(count);
        const world::World world = ballsInTwoSpaces(count, count + 1);
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

TEST(Clusters, holdTheBallsOfTheirInstances_andChildrenPartThem) {
    const world::World world = ballsInTwoSpaces(5000, 4);
    const Clusters clusters = frame::buildClusters(world);
    std::size_t leaves = 0;
    for (const Cluster& cluster : clusters.clusters) {
        ASSERT_LT(cluster.first, cluster.end);
        for (std::uint32_t p = cluster.first; p < cluster.end; ++p) {
            const Sphere& ball = clusters.bounds[p];
            EXPECT_EQ(ball.radius, world.instances[clusters.order[p]].bounds.radius);
            EXPECT_LE(glm::distance(ball.centre, cluster.bounds.centre) + ball.radius,
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

// However the world lists them: what is drawn later hides what is equally deep.
TEST(Clusters, doNotDependOnTheOrderOfTheLists) {
    world::World world = ballsInTwoSpaces(3000, 9);
    const Clusters before = frame::buildClusters(world);
    const auto second = world.spaceInstances.begin() + world.spaces[1].firstInstance;
    std::reverse(world.spaceInstances.begin(), second);
    const Clusters after = frame::buildClusters(world);
    EXPECT_TRUE(
        std::equal(before.order.begin(), before.order.begin() + before.firstShared, after.order.begin()));
}

} // namespace
} // namespace limen::test
