// What occluders hide is hidden: no ray of the reference meets an instance that a selection leaves out, over generated worlds.
#include "worlds/GeneratedWorlds.h"

#include "frame/Selection.h"
#include "frame/WorldGraph.h"
#include "reference/Picture.h"
#include "visibility/Flood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

namespace limen::test {
namespace {

using worlds::GeneratedKind;

struct OcclusionTally {
    std::size_t views = 0, several = 0, drawn = 0, hidden = 0, met = 0;
};

std::set<world::InstanceIndex> drawnBy(const frame::Clusters& clusters, const frame::Selection& selection) {
    std::set<world::InstanceIndex> out;
    for (const frame::SelectedRange& range : selection.ranges())
        for (std::uint32_t p = range.first; p < range.end; ++p)
            out.insert(clusters.order[p]);
    return out;
}

/// By id: the static instances.
std::map<std::uint32_t, world::InstanceIndex> instancesById(const world::World& world) {
    std::map<std::uint32_t, world::InstanceIndex> byId;
    for (world::InstanceIndex i = 0; i < world.instances.size(); ++i)
        byId.emplace(world.instances[i].idBase, i);
    return byId;
}

/// In the picture, without its border.
std::set<world::InstanceIndex> metIn(const std::map<std::uint32_t, world::InstanceIndex>& byId,
                                     const reference::Picture& picture) {
    std::set<world::InstanceIndex> out;
    for (int y = 0; y < static_cast<int>(picture.height); ++y)
        for (int x = 0; x < static_cast<int>(picture.width); ++x)
            if (const std::uint32_t id = picture.at(x, y).id; id > 1)
                out.insert(std::prev(byId.upper_bound(id))->second);
    return out;
}

/// A view from outside, near an instance, from close to the ground to high above it. One draw of a number a statement: the order
/// within an expression differs between compilers.
frame::FrameView viewFromOutside(const world::World& world, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const world::Instance& near = world.instances[random() % world.instances.size()];
    const double closeness = unit(random);
    const double away = near.bounds.radius + 40.0 * closeness * unit(random);
    const double angle = 2.0 * M_PI * unit(random);
    const double rise = 0.6 * unit(random) - 0.1;
    const double heading = 360.0 * unit(random);
    const double pitch = 50.0 * unit(random) - 40.0;
    const Vec3 eye = near.bounds.centre + away * Vec3(std::cos(angle), std::sin(angle), rise);
    return frame::makeView(eye, heading, pitch, 75.0, 200, 120, world::kOutside);
}

reference::Camera tracedBy(const frame::FrameView& view) {
    reference::Camera camera;
    camera.eye = view.view.eye;
    camera.right = view.view.right;
    camera.up = view.view.up;
    camera.forward = view.view.forward;
    camera.tanHalfX = view.view.tanHalfX;
    camera.tanHalfY = view.view.tanHalfY;
    camera.width = view.width;
    camera.height = view.height;
    return camera;
}

void checkWhatIsLeftOut(const world::World& world, std::uint32_t seed, OcclusionTally& tally) {
    const auto graph = frame::visibilityGraph(world);
    ASSERT_TRUE(graph);
    const frame::StaticScene scene(world);
    const reference::Scene traced(world);
    const auto byId = instancesById(world);
    frame::Selection selection(scene);
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    reference::Picture picture;
    std::mt19937 random(seed);
    for (int view = 0; view < 12; ++view) {
        frame::FrameView frame = viewFromOutside(world, random);
        ASSERT_TRUE(visibility::flood(*graph, {}, frame.view, {}, scratch, set));
        if (set.visits[0].space != world::kOutside)
            continue;
        selection.select(frame, {}, set);
        const auto all = drawnBy(scene.clusters(), selection);
        frame.occlusion = frame::Occlusion::Always;
        selection.select(frame, {}, set);
        const auto some = drawnBy(scene.clusters(), selection);
        ASSERT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
        reference::tracePicture(traced, tracedBy(frame), 1, picture);
        for (const world::InstanceIndex instance : metIn(byId, picture)) {
            if (all.contains(instance))
                EXPECT_TRUE(some.contains(instance))
                    << "seed " << seed << ", view " << view << ", instance " << instance;
            tally.met += some.contains(instance) ? 1 : 0;
        }
        ++tally.views;
        tally.several += set.visits.size() > 1 ? 1 : 0;
        tally.drawn += some.size();
        tally.hidden += all.size() - some.size();
    }
}

TEST(OcclusionProperty, noRayMeetsWhatIsLeftOut) {
    OcclusionTally tally;
    const auto checkKind = [&](GeneratedKind kind, std::uint32_t size, std::uint32_t seeds, int radius) {
        for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
            const worlds::test::GeneratedWorld files({kind, size, seed});
            checkWhatIsLeftOut(files.load(files.blocks()[files.blocks().size() / 2], seed % 2 == 0, radius),
                               seed, tally);
        }
    };
    checkKind(GeneratedKind::Town, 40, 10, 1);
    checkKind(GeneratedKind::Terrain, 12, 10, 1);
    EXPECT_GT(tally.views, 100u);
    EXPECT_GT(tally.several, tally.views / 10);
    EXPECT_GT(tally.met, 5 * tally.views);
    EXPECT_GT(tally.hidden, tally.drawn / 10) << "of " << tally.drawn;
}

} // namespace
} // namespace limen::test
