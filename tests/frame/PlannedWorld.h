#pragma once

#include "support/LoadTestWorld.h"
#include "support/TestWorld.h"

#include "frame/Planner.h"
#include "frame/WorldGraph.h"
#include "visibility/Flood.h"

#include <gtest/gtest.h>

namespace limen::test {

/// Two rooms in a row along +y, 4 × 4 × 3 m, joined by a door in y = 4; a table in each; the second has an
/// exit in y = 8 into a flat landscape with a box in it.
struct Rooms {
    TestWorld world;
    TestWorld::Cell first = world.addBox({90, 90, 0}, {94, 94, 3}, "brown");
    TestWorld::Cell second = world.addBox({90, 94, 0}, {94, 98, 3}, "blue");
    Rooms() {
        world.setFlatTerrain(world.home(), 0);
        world.link(first, rectangle({91, 94, 0}, {93, 94, 2}), second);
        const auto exit = world.openOutside(second, rectangle({91, 98, 0.1}, {93, 98, 2}));
        world.addBuilding(boxExterior({90, 90, 0}, {94, 98, 3}), {exit});
        const std::uint32_t table =
            world.addModel(insideOut(boxWalls({-0.2, -0.2, 0}, {0.2, 0.2, 0.8}, "red")));
        world.addStatic(first, table, frameAt({90.5, 91, 0}));
        world.addStatic(second, table, frameAt({93.4, 95, 0}));
        world.addObject(table, frameAt({92, 110, 0}));
    }
};

/// A loaded world, its scene and a planner.
struct PlannedWorld {
    explicit PlannedWorld(TestWorld& source, bool mergeZones = false)
        : world(loadTestWorld(source, {1, mergeZones})), graph(*frame::visibilityGraph(world)),
          spaceGraph(*frame::visibilityGraph(world, frame::GraphZones::EachSpace)), scene(world),
          planner(scene), pieces(scene.pieces().pieces), origin(toGlobal(source, Vec3(0.0))) {}

    const frame::FramePlan& planFrom(const Vec3& local, double yaw, world::SpaceIndex root) {
        view = frame::makeView(origin + local, yaw, 0.0, 75.0, 320, 200, root);
        view.gate = gate;
        view.coverageDecides = coverageDecides;
        view.rootFirst = view.fillsVoids = rootFirst;
        view.occlusion = occlusion;
        view.levels = levels;
        const visibility::Graph& flooded = gate == frame::Gate::Ownership ? graph : spaceGraph;
        EXPECT_TRUE(visibility::flood(flooded, {}, view.view, {}, scratch, visible));
        planner.plan(view, visible, plan);
        return plan;
    }

    /// The pieces that a batch draws, in order.
    [[nodiscard]] std::vector<frame::gpu::DrawPiece> piecesOf(const frame::Batch& batch) const {
        std::vector<frame::gpu::DrawPiece> drawn;
        for (std::uint32_t r = batch.first; r < batch.first + batch.count; ++r) {
            const auto ofRun = piecesOf(plan.runs[r]);
            drawn.insert(drawn.end(), ofRun.begin(), ofRun.end());
        }
        return drawn;
    }
    [[nodiscard]] std::vector<frame::gpu::DrawPiece> piecesOf(const frame::PieceRun& run) const {
        std::vector<frame::gpu::DrawPiece> drawn;
        for (std::uint32_t p = run.firstPiece; p < run.firstPiece + run.pieceCount; ++p)
            drawn.push_back(p < pieces.size() ? pieces[p] : plan.pieces[p - pieces.size()]);
        return drawn;
    }

    world::World world;
    visibility::Graph graph, spaceGraph;
    const frame::StaticScene scene;
    frame::Planner planner;
    std::vector<frame::gpu::DrawPiece> pieces; ///< resident
    Vec3 origin;
    visibility::FloodScratch scratch;
    visibility::VisibleSet visible;
    frame::Gate gate = frame::Gate::Ownership;          ///< of the next plans
    bool coverageDecides = false;                       ///< as FrameView::coverageDecides, of the next plans
    bool rootFirst = false;                             ///< as FrameView::rootFirst and fillsVoids
    world::LevelShare levels;                           ///< of the next plans
    frame::Occlusion occlusion = frame::Occlusion::Off; ///< of the next plans
    frame::FrameView view;
    frame::FramePlan plan;
};

} // namespace limen::test
