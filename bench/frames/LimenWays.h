#pragma once

#include "frames/FrameWay.h"

#include "DrawnPart.h"

namespace limen::bench {

/// The step that is left out of a frame.
enum class Without { Nothing, Visibility, Ownership };

/// Moves, floods, plans and submits a frame, without the one step.
[[nodiscard]] Result<void> drawFrame(DrawnPart& part, const frame::FrameView& view, Without without);

/// Limen with one set of renderer options, and the steps that are left out in turn.
struct LimenRenderer {
    std::string name; ///< of the way with every step
    gpu::RendererOptions options;
    std::vector<Without> without; ///< further ways, each without one step
};

/// The renderers that are compared. The targets are those of the first, which people see.
[[nodiscard]] std::vector<LimenRenderer> limenRenderers();

/// The name of a way: "exact", "exact without visibility".
[[nodiscard]] std::string wayName(const std::string& renderer, Without without);

/// The ways of `renderers`, with an OpenGL context that they share, the renderer's ways one after another.
/// Errors: Driver.
[[nodiscard]] Result<std::vector<std::unique_ptr<FrameWay>>>
makeLimenWays(const std::vector<LimenRenderer>& renderers, std::uint32_t width, std::uint32_t height);

} // namespace limen::bench
