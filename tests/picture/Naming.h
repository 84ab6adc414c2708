#pragma once

#include "picture/NaiveTracer.h"

#include "frame/FrameView.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::test {

/// The ray through a pixel centre; pixels beyond the border are allowed.
[[nodiscard]] NaiveTracer::Ray rayThrough(const frame::FrameView& frame, double x, double y);

/// The instance that shows as `id`, or kNone for void and sky.
[[nodiscard]] std::uint32_t instanceOfId(const world::World& world, std::uint32_t id);

/// "shell 0x20300100 polygon 3", "sky", "void".
[[nodiscard]] std::string describeId(const world::World& world, std::uint32_t id);

} // namespace limen::test
