#pragma once

#include "engine/FrameReport.h"

namespace limen::engine {

/// Tells frames apart by what was decided of them: eye, visits, where everything is that moves, what is shut. Equal
/// frames of one world have equal pictures. A picture's size does not count.
[[nodiscard]] std::uint64_t decisionHash(const FrameRequest& eye, const visibility::VisibleSet& visible,
                                         const world::DynamicState& dynamics);

} // namespace limen::engine
