#pragma once

#include "engine/Pipeline.h"
#include "world/Places.h"

#include <memory>
#include <optional>

namespace limen::bench {

/// Loads the blocks around a place. Errors: the loader's; NotFound if the place's space is not among them.
[[nodiscard]] Result<std::shared_ptr<const engine::LoadedPart>>
loadAround(const dat::Archive& archive, const world::WorldFile& file, const world::Place& place,
           const world::LoadOptions& options = {});
/// Whether a place's space is in a loaded part.
[[nodiscard]] bool holds(const engine::LoadedPart& part, const world::Place& place);
inline constexpr double kFieldOfView = 75.0; ///< of the views, degrees high
/// A view from a place, turned by `turn` degrees. The position decides on the root if the place names no cell.
[[nodiscard]] frame::FrameView viewFrom(const engine::LoadedPart& part, const world::Place& place,
                                        std::uint32_t width, std::uint32_t height, double turn = 0.0);
/// The input of a dynamic state in which only the eye matters.
[[nodiscard]] motion::DynamicStateInput dynamicsFor(const frame::FrameView& view);

/// The blocks around a place on a device: the engine's pipeline with a target, its steps taken one by one.
/// The device must outlive it.
class DrawnPart {
public:
    /// Errors: the loader's, the renderer's; NotFound if the place's space is not loaded.
    [[nodiscard]] static Result<std::unique_ptr<DrawnPart>>
    around(const dat::Archive& archive, const world::WorldFile& file, const world::Place& place,
           gpu::Device& device, std::uint32_t width, std::uint32_t height,
           const world::LoadOptions& options = {});

    /// A part that is loaded already. Errors: those of the target and the renderer.
    [[nodiscard]] static Result<std::unique_ptr<DrawnPart>>
    of(std::shared_ptr<const engine::LoadedPart> loaded, gpu::Device& device, std::uint32_t width,
       std::uint32_t height, const gpu::RendererOptions& options = {});

    /// Whether a place's space is loaded.
    [[nodiscard]] bool holds(const world::Place& place) const { return bench::holds(part(), place); }
    /// A view from a place with the target's size.
    [[nodiscard]] frame::FrameView viewFrom(const world::Place& place, double turn = 0.0) const {
        return bench::viewFrom(part(), place, target_.width(), target_.height(), turn);
    }

    /// Sets the gate of later floods and plans.
    void setGate(frame::Gate gate) { pipeline_.setGate(gate); }
    /// Updates the dynamic state. `doors`: openness of all of them; none: each keeps its resting openness.
    void move(const frame::FrameView& view, std::optional<double> doors = {});
    /// Requires a view of this part.
    void flood(const frame::FrameView& view);
    /// The visible set of a renderer without visibility: every space, over the whole picture, in one visit.
    void takeAll(const frame::FrameView& view);
    void plan(const frame::FrameView& view) { pipeline_.plan(view); }
    /// Removes ownership from the plan: no ownership stage and no fragment tests.
    void leaveOutOwnership();
    [[nodiscard]] Result<void> submit(const gpu::RenderOptions& options = {}) {
        return pipeline_.render(target_, options);
    }

    [[nodiscard]] const engine::LoadedPart& part() const { return pipeline_.part(); }
    [[nodiscard]] const frame::FramePlan& plan() const { return pipeline_.state().plan; }
    [[nodiscard]] const gpu::Renderer& renderer() const { return pipeline_.renderer(); }
    [[nodiscard]] const gpu::RenderTarget& target() const { return target_; }

private:
    DrawnPart(gpu::Device& device, gpu::RenderTarget target, const gpu::RendererOptions& options)
        : pipeline_(device, options), target_(std::move(target)) {}

    engine::Pipeline pipeline_;
    gpu::RenderTarget target_;
};

/// Loads the parts around places that are visited in turn, one at a time. The device must outlive it.
class PartOfTour {
public:
    PartOfTour(const dat::Archive& archive, const world::WorldFile& file, gpu::Device& device,
               std::uint32_t width, std::uint32_t height, gpu::RendererOptions options = {})
        : archive_(archive), file_(file), device_(device), width_(width), height_(height),
          options_(std::move(options)) {}

    /// Loads the blocks around a place unless its space is loaded already. Errors: as DrawnPart::around.
    [[nodiscard]] Result<DrawnPart*> at(const world::Place& place);

private:
    const dat::Archive& archive_;
    const world::WorldFile& file_;
    gpu::Device& device_;
    std::uint32_t width_, height_;
    gpu::RendererOptions options_;
    std::unique_ptr<DrawnPart> part_;
};

} // namespace limen::bench
