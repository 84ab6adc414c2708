#pragma once

#include "engine/FrameRequest.h"
#include "engine/LoadedPart.h"
#include "gpu/RenderTarget.h"
#include "gpu/Renderer.h"
#include "visibility/Flood.h"

#include <memory>
#include <optional>

namespace limen::engine {

/// The results of a frame's steps, in the order of the steps.
struct FrameState {
    world::DynamicState dynamics;
    visibility::VisibleSet visible;
    frame::FramePlan plan;
};

/// The steps of a frame: dynamic state, flood, plan, render. Holds one part of a world on one device. The
/// steps are public, because benchmarks time them one by one and tests leave some out. In steady frames, our
/// code allocates nothing.
class Pipeline {
public:
    /// The device must outlive it.
    explicit Pipeline(gpu::Device& device, const gpu::RendererOptions& options = {})
        : renderer_(device, options) {}

    /// Uploads a part in this call and draws it from now on. Errors: the renderer's; the old part then stays.
    [[nodiscard]] Result<void> show(std::unique_ptr<PartPlanner> part);
    /// Takes a part whose scene the renderer has just swapped in. Returns the part drawn before, or null.
    [[nodiscard]] std::unique_ptr<PartPlanner> take(std::unique_ptr<PartPlanner> part);

    [[nodiscard]] bool hasPart() const { return part_ != nullptr; }
    /// Requires a part, as do all functions below except sharePart, state and renderer.
    [[nodiscard]] const LoadedPart& part() const;
    [[nodiscard]] std::shared_ptr<const LoadedPart> sharePart() const;

    /// Sets the gate of the next floods and plans. Gates may change from frame to frame.
    void setGate(frame::Gate gate);
    [[nodiscard]] frame::Gate gate() const { return gate_; }

    void updateDynamics(const motion::DynamicStateInput& input);
    /// Uses the closed openings of the last dynamic state. Errors: as visibility::flood.
    [[nodiscard]] Result<void> flood(const visibility::View& view, const visibility::Limits& limits = {});
    /// A flood that only reports the fate of each portal; the frame's visible set stays.
    [[nodiscard]] Result<void> trace(const visibility::View& view, visibility::FloodTrace& trace);
    /// Plans from the last flood, which must be from `view.view`.
    void plan(const frame::FrameView& view);
    /// Draws the last plan. Errors: the renderer's.
    [[nodiscard]] Result<void> render(gpu::RenderTarget& target, const gpu::RenderOptions& options = {});

    /// The state of the last frame. Writable, so that benchmarks and tests can replace the result of a step.
    [[nodiscard]] FrameState& state() { return state_; }
    [[nodiscard]] const FrameState& state() const { return state_; }
    [[nodiscard]] gpu::Renderer& renderer() { return renderer_; }
    [[nodiscard]] const gpu::Renderer& renderer() const { return renderer_; }

private:
    [[nodiscard]] world::LevelShare drawnLevels(const world::LevelShare& asked) const;
    /// The graph that the gate's flood follows. Errors: portals that the graph refuses.
    [[nodiscard]] Result<const visibility::Graph*> graph();

    std::unique_ptr<PartPlanner> part_;
    frame::Gate gate_ = frame::Gate::Ownership;
    /// Of the part, with a zone for each space; made for the first frame of another gate than Gate::Ownership.
    std::optional<visibility::Graph> spaceGraph_;
    gpu::Renderer renderer_;
    visibility::FloodScratch scratch_;
    FrameState state_;
    bool isPlanned_ = false; ///< the plan is of the current part and dynamic state
};

} // namespace limen::engine
