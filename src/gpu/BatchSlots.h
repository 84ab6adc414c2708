#pragma once

#include "frame/FramePlan.h"
#include "gpu/RenderOptions.h"

#include <vector>

namespace limen::gpu {

/// Draw commands of a batch: consecutive slots in up to two parts. Without a split, `second` is `end`.
struct BatchSlots {
    std::uint32_t first = 0, second = 0, end = 0;
    bool lampsInFirst = false, lampsInSecond = false; ///< whether lamps light any of the part's draws
    bool isJoined = false; ///< an earlier batch of the same program has this one's draws; it makes no calls
};

/// Whether a batch's draws are indexed, and drawn in a frame with these options: then they have slots.
[[nodiscard]] bool hasSlots(const frame::Batch& batch, const RenderOptions& options);

/// Assigns slots to the plan's indexed draws, batch by batch, without a split. Keeps the capacity of `slots`.
void assignSlots(const frame::FramePlan& plan, const RenderOptions& options, std::vector<BatchSlots>& slots);

} // namespace limen::gpu
