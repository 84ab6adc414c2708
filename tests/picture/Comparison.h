#pragma once

#include "picture/NaiveTracer.h"

#include "frame/FrameView.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::test {

/// A drawn id image held against the ray rule: a pixel disagrees if its id is not among the traced ids of the
/// 3×3 pixels around it.
struct Comparison {
    std::size_t pixels = 0, disagreeing = 0;
    std::size_t slivers = 0; ///< would disagree, but finer rays within the 3×3 pixels meet what was drawn
    std::size_t voids = 0;   ///< drawn ids of 0
    std::size_t outsideWithoutRay =
        0;             ///< terrain, sky and the like where no ray of the 3×3 pixels got outside
    std::string first; ///< where the first disagreement is and what was drawn and traced
};

/// `ids`: row 0 on top, frame.width × frame.height.
[[nodiscard]] Comparison compare(const world::World& world, const NaiveTracer& tracer,
                                 const frame::FrameView& frame, const std::vector<std::uint32_t>& ids);

/// The ray through a pixel centre; pixels beyond the border are fine.
[[nodiscard]] NaiveTracer::Ray rayThrough(const frame::FrameView& frame, double x, double y);

/// The instance that shows as `id`, or kNone for void and sky.
[[nodiscard]] std::uint32_t instanceOfId(const world::World& world, std::uint32_t id);

/// "shell 0x20300100 polygon 3", "sky", "void".
[[nodiscard]] std::string describeId(const world::World& world, std::uint32_t id);

} // namespace limen::test
