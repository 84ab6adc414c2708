// Clusters save tests and change no result: compared with a test of each instance, over generated worlds with
// dynamic instances.
#include "NaiveSelection.h"
#include "worlds/GeneratedWorlds.h"

#include "frame/Selection.h"
#include "frame/WorldGraph.h"
#include "visibility/Flood.h"

#include <gtest/gtest.h>

#include <random>

namespace limen::test {
namespace {

using worlds::GeneratedKind;

/// Dynamic instances: moved copies of static ones, each a member of one to three consecutive spaces.
world::DynamicState movedCopies(const world::World& world, std::uint32_t count, std::mt19937& random) {
    world::DynamicState dynamics;
    std::uniform_real_distribution<double> offset(-3.0, 3.0);
    for (std::uint32_t i = 0; i < count; ++i) {
        world::Instance instance = world.instances[random() % world.instances.size()];
        instance.bounds.centre += Vec3(offset(random), offset(random), offset(random));
        instance.setMembers(static_cast<std::uint32_t>(dynamics.members.size()),
                            std::min<std::size_t>(1 + random() % 3, world.spaces.size()));
        auto space = static_cast<world::SpaceIndex>(random() % world.spaces.size());
        for (std::uint32_t m = 0; m < instance.memberCount; ++m) {
            dynamics.members.push_back(space);
            space = static_cast<world::SpaceIndex>((space + 1) % world.spaces.size());
        }
        dynamics.instances.push_back(instance);
    }
    world::listBySpace(world.spaces.size(), dynamics);
    return dynamics;
}

/// A view from a point near an instance, in its space or outside.
frame::FrameView anyView(const world::World& world, std::mt19937& random) {
    std::uniform_real_distribution<double> part(-0.5, 0.5), unit(0.0, 1.0);
    const world::Instance& near = world.instances[random() % world.instances.size()];
    const Vec3 eye = near.bounds.centre +
                     Vec3(part(random), part(random), part(random)) * std::min(near.bounds.radius, 30.0);
    return frame::makeView(eye, 360.0 * unit(random), 60.0 * unit(random) - 30.0, 75.0, 320, 200,
                           random() % 4 == 0 ? world::kOutside : near.placedIn);
}

std::map<std::uint32_t, bool> chosen(const world::World& world, const frame::Clusters& clusters,
                                     const world::DynamicState& dynamics, const frame::Selection& selection) {
    std::map<std::uint32_t, bool> drawn;
    std::uint32_t end = 0;
    for (const frame::SelectedRange& range : selection.ranges()) {
        EXPECT_GE(range.first, end) << "in order";
        EXPECT_LT(range.first, range.end);
        end = range.end;
        for (std::uint32_t p = range.first; p < range.end; ++p)
            drawn[clusters.order[p]] = range.gated;
    }
    std::uint32_t next = 0;
    for (const frame::SelectedDynamic selected : selection.dynamicInstances()) {
        const world::InstanceIndex index = dynamics.listed.instance[selected & ~frame::gpu::kGated];
        EXPECT_GE(index, next) << "in order, once";
        next = index + 1;
        drawn[static_cast<std::uint32_t>(world.instances.size()) + index] =
            (selected & frame::gpu::kGated) != 0;
    }
    EXPECT_EQ(drawn.size(), selection.counts().drawn);
    return drawn;
}

/// Removes the static instances whose level of detail is out of range: a selection may leave them out. Returns their
/// number.
std::size_t removeFarther(const world::World& world, const Vec3& eye, const world::LevelShare& share,
                          std::map<std::uint32_t, bool>& drawn) {
    const world::RangeSteps steps = world::rangeStepsOf(eye);
    return std::erase_if(drawn, [&](const auto& entry) {
        return entry.first < world.instances.size() &&
               !world::isInLevelRange(world, world.instances[entry.first], steps, share);
    });
}

/// Whether the eye is in range of every instance of which a range says so.
bool areInRange(const world::World& world, const frame::Clusters& clusters, const frame::FrameView& frame,
                std::span<const frame::SelectedRange> ranges) {
    const world::RangeSteps steps = world::rangeStepsOf(frame.view.eye);
    for (const frame::SelectedRange& range : ranges)
        for (std::uint32_t p = range.first; p < range.end; ++p)
            if (range.inRange &&
                !world::isInLevelRange(world, world.instances[clusters.order[p]], steps, frame.levels))
                return false;
    return true;
}

/// Gives every second static instance a random level of detail.
world::World withLevels(world::World world, std::mt19937& random) {
    std::uniform_real_distribution<double> metres(0.0, 60.0);
    for (world::Instance& instance : world.instances) {
        if (random() % 2 == 0 || instance.block == world::kNone)
            continue;
        const double from = random() % 2 == 0 ? 0.0 : metres(random);
        const double upTo = random() % 4 == 0 ? 1e9 : from + metres(random);
        instance.level = static_cast<std::uint32_t>(world.levels.size());
        world.levels.push_back(
            {{world::levelRangeLimit(from), world::levelRangeLimit(upTo)},
             random() % 2 == 0 ? world::LevelMeasure::Landcell : world::LevelMeasure::Object,
             world::localRangeSteps(Vec3(instance.origin))});
    }
    return world;
}

struct Tally {
    std::size_t views = 0, several = 0, drawn = 0, ungated = 0, more = 0;
    std::size_t outOfRange = 0, expectedOutOfRange = 0; ///< instances
};

void compareViews(const world::World& world, std::uint32_t seed, Tally& tally) {
    const auto graph = frame::visibilityGraph(world);
    ASSERT_TRUE(graph);
    const frame::StaticScene scene(world);
    const frame::Clusters& clusters = scene.clusters();
    frame::Selection selection(scene);
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    std::mt19937 random(seed);
    for (int view = 0; view < 40; ++view) {
        const world::DynamicState dynamics = movedCopies(world, view % 2 * 50u, random);
        frame::FrameView frame = anyView(world, random);
        frame.levels = {view % 3 == 0 ? 8u : 16u};
        ASSERT_TRUE(visibility::flood(*graph, {}, frame.view, {}, scratch, set));
        selection.select(frame, dynamics, set);
        auto drawn = chosen(world, clusters, dynamics, selection);
        auto expected = selectOneByOne(world, dynamics, frame, set);
        ASSERT_TRUE(areInRange(world, clusters, frame, selection.ranges()))
            << "seed " << seed << ", view " << view;
        const std::size_t outOfRange = removeFarther(world, frame.view.eye, frame.levels, drawn);
        ASSERT_TRUE(outOfRange == 0 || set.visits.size() == 1) << "each is tested";
        tally.outOfRange += outOfRange;
        tally.expectedOutOfRange += removeFarther(world, frame.view.eye, frame.levels, expected);
        if (set.visits.size() > 1) {
            ASSERT_EQ(drawn, expected) << "seed " << seed << ", view " << view;
        } else { // clusters across the picture's edges are drawn whole
            ASSERT_TRUE(std::includes(drawn.begin(), drawn.end(), expected.begin(), expected.end()));
            tally.more += drawn.size() - expected.size();
        }
        ++tally.views;
        tally.several += set.visits.size() > 1 ? 1 : 0;
        tally.drawn += drawn.size();
        tally.ungated += selection.counts().ungated;
    }
}

TEST(SelectionProperty, selectsTheSameAsTestingEachInstance) {
    Tally tally;
    const auto compareKind = [&](GeneratedKind kind, std::uint32_t size, std::uint32_t seeds, int radius) {
        for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
            const worlds::test::GeneratedWorld files({kind, size, seed});
            world::World world = files.load(files.blocks()[files.blocks().size() / 2], seed % 2 == 0, radius);
            std::mt19937 random(seed);
            if (seed % 4 < 2)
                world = withLevels(std::move(world), random);
            compareViews(world, seed, tally);
        }
    };
    compareKind(GeneratedKind::Complex, 60, 8, 0);
    compareKind(GeneratedKind::Dungeon, 120, 8, 0);
    compareKind(GeneratedKind::Town, 40, 6, 1);
    compareKind(GeneratedKind::Terrain, 12, 6, 1);
    EXPECT_GT(tally.several, tally.views / 3);
    EXPECT_LT(tally.several, tally.views) << "and some with a single visit";
    EXPECT_GT(tally.drawn, 10 * tally.views);
    EXPECT_GT(tally.ungated, tally.drawn / 20);
    EXPECT_LT(tally.more, tally.drawn / 5);
    EXPECT_GT(tally.expectedOutOfRange, 2 * tally.views);
    EXPECT_LT(tally.outOfRange, 9 * tally.expectedOutOfRange / 10) << "clusters out of range are left out";
}

} // namespace
} // namespace limen::test
