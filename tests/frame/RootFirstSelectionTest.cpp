// In a plan that draws the root by itself each static instance has the turn that a test in every visit gives it.
#include "worlds/GeneratedWorlds.h"

#include "frame/Selection.h"
#include "frame/WorldGraph.h"
#include "visibility/Flood.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

namespace limen::test {
namespace {

using frame::Turn;
using visibility::Containment;

/// How a static instance is drawn.
struct Drawn {
    Turn turn = Turn::After;
    bool gated = false;
    friend bool operator==(const Drawn&, const Drawn&) = default;
};
using DrawnByInstance = std::map<world::InstanceIndex, Drawn>;

/// By testing each instance that one space lists in every visit.
DrawnByInstance expectedTurns(const world::World& world, const frame::FrameView& frame,
                              const visibility::VisibleSet& set) {
    visibility::Viewcones cones;
    cones.prepare(frame.view, set,
                  2.0 * std::max(frame.view.tanHalfX / frame.width, frame.view.tanHalfY / frame.height));
    struct Seen {
        bool inRoot = false;
        Containment inOthers = Containment::Outside;
    };
    std::map<world::InstanceIndex, Seen> seen;
    for (const visibility::SeenSpace& in : set.seen) {
        const world::Space& space = world.spaces[in.space];
        for (std::uint32_t i = space.firstInstance; i < space.firstInstance + space.instanceCount; ++i) {
            const world::InstanceIndex number = world.spaceInstances[i];
            const world::Instance& instance = world.instances[number];
            const auto sphere =
                cones.sphereOf({instance.bounds.centre - frame.view.eye, instance.bounds.radius});
            const bool inRect =
                visibility::Viewcones::classify(cones.edgesOf(in.rect), sphere) != Containment::Outside;
            if (instance.memberCount != 1 || !inRect)
                continue;
            if (in.visit == 0)
                seen[number].inRoot = cones.classifyInRoot(sphere) != Containment::Outside;
            else
                seen[number].inOthers = std::max(seen[number].inOthers, cones.classify(in.visit, sphere));
        }
    }
    DrawnByInstance drawn;
    for (const auto& [number, by] : seen)
        if (by.inOthers == Containment::Inside)
            drawn[number] = {Turn::After, false};
        else if (by.inOthers == Containment::Partial)
            drawn[number] = {by.inRoot ? Turn::Both : Turn::After, true};
        else if (by.inRoot)
            drawn[number] = {Turn::Before, false};
    return drawn;
}

DrawnByInstance selectedTurns(const frame::StaticScene& scene, const frame::Selection& selection) {
    DrawnByInstance drawn;
    for (const frame::SelectedRange& range : selection.ranges()) {
        for (std::uint32_t p = range.first; p < range.end; ++p) {
            const world::InstanceIndex number = scene.clusters().order[p];
            if (scene.world().instances[number].memberCount == 1)
                drawn[number] = {range.turn, range.gated};
            else
                EXPECT_EQ(range.turn, Turn::After) << "drawn once, for all visits";
        }
    }
    return drawn;
}

TEST(RootFirstSelection, hasTheTurnsThatEachInstanceHasByItself) {
    std::map<Turn, std::size_t> turns;
    std::size_t views = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const worlds::test::GeneratedWorld files({worlds::GeneratedKind::Town, 40, seed});
        const world::World world = files.load(files.blocks()[files.blocks().size() / 2], seed % 2 == 0, 1);
        const auto graph = frame::visibilityGraph(world);
        ASSERT_TRUE(graph);
        const frame::StaticScene scene(world);
        frame::Selection selection(scene);
        visibility::FloodScratch scratch;
        visibility::VisibleSet set;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (int view = 0; view < 60; ++view) {
            const world::Instance& near = world.instances[random() % world.instances.size()];
            const Vec3 eye =
                near.bounds.centre + Vec3(20.0 * unit(random), 20.0 * unit(random), 4.0 * unit(random));
            const frame::FrameView frame = frame::makeView(
                eye, 360.0 * unit(random), 30.0 * unit(random) - 20.0, 75.0, 640, 360, world::kOutside);
            ASSERT_TRUE(visibility::flood(*graph, {}, frame.view, {}, scratch, set));
            if (set.visits.size() == 1)
                continue;
            selection.select(frame, {}, set, true);
            const DrawnByInstance drawn = selectedTurns(scene, selection);
            const DrawnByInstance expected = expectedTurns(world, frame, set);
            ASSERT_EQ(drawn.size(), expected.size()) << "seed " << seed << ", view " << view;
            ASSERT_TRUE(drawn == expected) << "seed " << seed << ", view " << view;
            for (const auto& [number, by] : drawn)
                ++turns[by.turn];
            ++views;
        }
    }
    EXPECT_GT(views, 100u);
    EXPECT_GT(turns[Turn::Before], 20 * views);
    EXPECT_GT(turns[Turn::After], views);
    EXPECT_GT(turns[Turn::Both], views / 4);
}

} // namespace
} // namespace limen::test
