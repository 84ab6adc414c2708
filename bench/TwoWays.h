#pragma once

#include "ObjectField.h"
#include "classic/ClassicPath.h"

#include "frame/Planner.h"
#include "gpu/RenderTarget.h"
#include "gpu/Renderer.h"

#include <memory>

namespace limen::bench {

/// Draws a field with ids into one target, either by the renderer or by the classic path. Field and device
/// must outlive it.
class TwoWays {
public:
    /// Errors: those of the device and of the renderer.
    [[nodiscard]] static Result<std::unique_ptr<TwoWays>>
    create(gpu::Device& device, const ObjectField& field, std::uint32_t width, std::uint32_t height);

    /// Plans and submits one frame with the renderer. `view` has the target's size.
    [[nodiscard]] Result<void> drawReal(const FieldView& view);
    [[nodiscard]] Result<void> drawClassic(const FieldView& view);

    /// The last frame.
    [[nodiscard]] const gpu::RenderTarget& target() const { return target_; }
    [[nodiscard]] const frame::FramePlan& plan() const { return plan_; }
    [[nodiscard]] const ClassicPath& classic() const { return *classic_; }

private:
    TwoWays(gpu::Device& device, const ObjectField& field, gpu::RenderTarget target)
        : field_(field), scene_(field.world), planner_(scene_), renderer_(device),
          target_(std::move(target)) {}

    const ObjectField& field_;
    const frame::StaticScene scene_;
    frame::Planner planner_;
    frame::FramePlan plan_;
    gpu::Renderer renderer_;
    std::unique_ptr<ClassicPath> classic_;
    gpu::RenderTarget target_;
};

} // namespace limen::bench
