#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "frame/StaticScene.h"

namespace limen::frame {

/// The colour of an object's highlight, 0 if it has none. If several highlights name the object, the last one
/// wins.
[[nodiscard]] std::uint32_t colourOf(std::span<const Highlight> highlights, std::uint64_t object);

/// Highlights static instances. Their resident records never change. So the plan gets a record of its own for
/// each of them, and a replacement that makes the device draw by it. Objects that the world does not have are
/// ignored. Allocates nothing once a plan has held as many. Requires the plan's constants and dynamic
/// instances.
void replaceHighlighted(const StaticScene& scene, std::span<const Highlight> highlights, FramePlan& plan);

} // namespace limen::frame
