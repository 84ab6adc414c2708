#include "engine/Pipeline.h"

#include "core/Assert.h"
#include "frame/SceneBuilder.h"
#include "frame/WorldGraph.h"
#include "visibility/EyeSpace.h"

#include <utility>

namespace limen::engine {

Result<void> Pipeline::show(std::unique_ptr<PartPlanner> part) {
    LIMEN_ASSERT(part != nullptr, "there is a part to show");
    if (Result<void> uploaded = renderer_.upload(frame::buildScene(part->part->scene)); !uploaded)
        return uploaded;
    static_cast<void>(take(std::move(part)));
    return {};
}

std::unique_ptr<PartPlanner> Pipeline::take(std::unique_ptr<PartPlanner> part) {
    LIMEN_ASSERT(part != nullptr, "there is a part to show");
    isPlanned_ = false;
    spaceGraph_.reset();
    return std::exchange(part_, std::move(part));
}

const LoadedPart& Pipeline::part() const {
    LIMEN_ASSERT(part_ != nullptr, "show a part first");
    return *part_->part;
}

std::shared_ptr<const LoadedPart> Pipeline::sharePart() const {
    return part_ != nullptr ? part_->part : nullptr;
}

void Pipeline::setGate(frame::Gate gate) {
    isPlanned_ = isPlanned_ && gate == gate_;
    gate_ = gate;
}

Result<const visibility::Graph*> Pipeline::graph() {
    if (gate_ == frame::Gate::Ownership)
        return &part().graph;
    if (!spaceGraph_) {
        Result<visibility::Graph> made = frame::visibilityGraph(part().world, frame::GraphZones::EachSpace);
        if (!made)
            return Failure(made.error());
        spaceGraph_.emplace(std::move(*made));
    }
    return &*spaceGraph_;
}

// In exact frames the device selects levels of detail, at whole distances.
world::LevelShare Pipeline::drawnLevels(const world::LevelShare& asked) const {
    return renderer_.options().drawing == gpu::Drawing::Fast && gate_ == frame::Gate::Ownership
               ? asked
               : world::LevelShare{};
}

void Pipeline::updateDynamics(const motion::DynamicStateInput& input) {
    LIMEN_ASSERT(part_ != nullptr, "show a part first");
    motion::DynamicStateInput drawn = input;
    drawn.levels = drawnLevels(input.levels);
    part_->dynamics.build(drawn, state_.dynamics);
    isPlanned_ = false;
}

Result<void> Pipeline::flood(const visibility::View& view, const visibility::Limits& limits) {
    isPlanned_ = false;
    const Result<const visibility::Graph*> graph = this->graph();
    if (!graph)
        return Failure(graph.error());
    return visibility::flood(**graph, state_.dynamics.closed, view, limits, scratch_, state_.visible);
}

Result<void> Pipeline::trace(const visibility::View& view, visibility::FloodTrace& trace) {
    visibility::VisibleSet visible;
    return visibility::flood(part().graph, state_.dynamics.closed, view, {}, scratch_, visible, &trace);
}

void Pipeline::plan(const frame::FrameView& view) {
    LIMEN_ASSERT(part_ != nullptr, "show a part first");
    LIMEN_ASSERT(!state_.visible.visits.empty() &&
                     state_.visible.visits[0].space ==
                         visibility::spaceOfEye(part().graph, view.view.eye, view.view.root),
                 "the flood was from this view");
    frame::FrameView planned = view;
    planned.gate = gate_;
    planned.fewTests = planned.fillsVoids = planned.coverageDecides =
        renderer_.options().drawing == gpu::Drawing::Fast;
    planned.rootFirst = renderer_.choices().rootFirst;
    planned.levels = drawnLevels(view.levels);
    if (!renderer_.choices().occludes)
        planned.occlusion = frame::Occlusion::Off;
    part_->planner.plan(planned, state_.dynamics, state_.visible, state_.plan);
    isPlanned_ = true;
}

Result<void> Pipeline::render(gpu::RenderTarget& target, const gpu::RenderOptions& options) {
    LIMEN_ASSERT(isPlanned_, "plan before rendering: the plan refers to this part and dynamic state");
    return renderer_.render(state_.plan, target, options);
}

} // namespace limen::engine
