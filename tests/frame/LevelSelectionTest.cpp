#include "SpheresInTwoSpaces.h"

#include "frame/LevelSelection.h"
#include "visibility/TestGraph.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace limen::test {
namespace {

using frame::Cluster;
using frame::Clusters;
using visibility::Containment;

constexpr double kNearPlane = 0.1;

/// A view with one visit, which has the whole picture.
struct OneVisit {
    OneVisit(const Vec3& from, double yaw, double pitch) : eye(from) {
        visibility::TestGraph world;
        world.addSpace();
        view = visibility::viewFrom(eye, yaw, pitch, 0);
        cones.prepare(view, visibility::floodOnce(world.build(), view), 0.002);
    }
    [[nodiscard]] Containment lies(const Sphere& sphere) const {
        return cones.classify(0, cones.sphereOf({sphere.centre - eye, sphere.radius}));
    }
    Vec3 eye;
    visibility::View view;
    visibility::Viewcones cones;
};

/// The expected selection, without optimization: one cluster after the other.
void choose(const Clusters& clusters, const Cluster& cluster, const OneVisit& from,
            std::vector<bool>& chosen) {
    const Containment levels = cluster.detail.at(cluster.bounds.centre - from.eye, {});
    if (levels == Containment::Outside)
        return;
    const Containment seen = from.lies(cluster.bounds);
    const bool isOpened =
        seen == Containment::Inside && levels == Containment::Partial && cluster.childCount > 0;
    const Containment lies = isOpened ? Containment::Partial : seen;
    const double ahead = glm::dot(cluster.bounds.centre - from.eye, from.view.forward);
    if (lies == Containment::Inside || (lies == Containment::Partial && cluster.childCount == 0 &&
                                        ahead > cluster.bounds.radius + kNearPlane))
        std::fill(chosen.begin() + cluster.first, chosen.begin() + cluster.end, true);
    else if (lies == Containment::Partial && cluster.childCount == 0)
        for (std::uint32_t i = cluster.first; i < cluster.end; ++i)
            chosen[i] = from.lies(clusters.bounds[i]) != Containment::Outside;
    else if (lies == Containment::Partial)
        for (std::uint32_t i = 0; i < cluster.childCount; ++i)
            choose(clusters, clusters.clusters[cluster.firstChild + i], from, chosen);
}

struct Tally {
    std::size_t drawn = 0, left = 0, ranges = 0;
};

/// Compares 200 views of a world.
void compareViews(const world::World& world, std::mt19937& random, Tally& tally) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    const Clusters clusters = frame::buildClusters(world);
    const frame::ClusterBatches batches(clusters);
    frame::LevelSelection levels(clusters, batches);
    for (int i = 0; i < 200; ++i) {
        const OneVisit from({between(-50, 450), between(-50, 450), between(0, 60)}, between(0, 360),
                            between(-80, 80));
        for (world::SpaceIndex space = 0; space < 2; ++space) {
            if (clusters.roots[space] == world::kNone)
                continue;
            std::vector<bool> expected(clusters.order.size(), false), chosen = expected;
            choose(clusters, clusters.clusters[clusters.roots[space]], from, expected);
            std::uint32_t end = 0;
            for (const auto& range :
                 levels.select(space, from.cones, from.eye, from.view.forward, kNearPlane)) {
                ASSERT_TRUE(range.first > end || range.first == 0) << "in order and disjoint";
                ASSERT_LT(range.first, range.end);
                end = range.end;
                std::fill(chosen.begin() + range.first, chosen.begin() + range.end, true);
                ++tally.ranges;
            }
            ASSERT_EQ(chosen, expected) << "view " << i << ", space " << space;
            const auto shown = static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), true));
            tally.drawn += shown;
            tally.left += chosen.size() - shown;
        }
    }
}

TEST(LevelSelection, selectsTheSameAsARecursiveDescent) {
    std::mt19937 random(3);
    Tally tally, withLevels;
    for (const std::uint32_t count : {1u, 16u, 17u, 64u, 130u, 700u, 3000u}) {
        SCOPED_TRACE(count);
        compareViews(spheresInTwoSpaces(count, count), random, tally);
        compareViews(spheresWithLevels(count, count), random, withLevels);
    }
    for (const Tally& each : {tally, withLevels}) {
        EXPECT_GT(each.drawn, 10'000u);
        EXPECT_GT(each.left, 10'000u);
        EXPECT_GT(each.ranges, 1'000u);
    }
}

} // namespace
} // namespace limen::test
