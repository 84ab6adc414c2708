#pragma once

#include "frames/FrameWay.h"

namespace limen::bench {

/// A plain forward renderer, in a context of its own: everything in the frustum, one instanced draw for each
/// mesh and material, hardware outlines, an early depth test, one light for each vertex and one texture for
/// each fragment. No visibility, no lamps, fog, sky or blended terrain. The driver's own state is all that it
/// keeps. Errors: Driver.
[[nodiscard]] Result<std::unique_ptr<FrameWay>> makePlainWay(std::uint32_t width, std::uint32_t height);

} // namespace limen::bench
