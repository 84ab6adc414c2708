#pragma once

#include "DrawnPart.h"

#include <array>
#include <optional>
#include <vector>

namespace limen::bench {

/// Figures of one frame.
struct GateFrame {
    double milliseconds = 0.0;   ///< from the flood until the rasteriser is done; the median over the repeats
    std::uint32_t calls = 0;     ///< GL calls
    std::uint32_t draws = 0;     ///< draw commands
    std::uint32_t fallbacks = 0; ///< regions drawn in their rectangle
    std::optional<double> fragments; ///< fragment shader invocations; none: the driver does not count them
};

/// Frames of all gates at each place: frames[place][gate], in the order of frame::kGates.
struct GateFrames {
    std::vector<std::array<GateFrame, frame::kGates.size()>> places;
    std::array<std::uint64_t, frame::kGates.size()> hashes{}; ///< of the pictures of each gate
};

struct GateEffort {
    std::uint32_t width = 640, height = 360;
    int repeats = 5; ///< of each gate at each place, after a frame to warm up
};

/// Draws every place with every gate; the gates take turns, so that other programs disturb all of them alike.
/// Requires a current context. Errors: Driver; the loader's; the renderer's.
[[nodiscard]] Result<GateFrames> timeGates(gpu::Device& device, const dat::Archive& archive,
                                           const world::WorldFile& file,
                                           const std::vector<world::Place>& places,
                                           const gpu::RendererOptions& options,
                                           const GateEffort& effort = {});

} // namespace limen::bench
