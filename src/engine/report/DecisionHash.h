#pragma once

#include "engine/FrameRequest.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

#include <cstdint>

namespace limen::engine {

/// Hash of the decisions behind a frame: eye, scene, visits, poses of dynamic instances, closed openings. Two
/// frames of one world with the same hash have the same picture. The size of the picture does not enter the
/// hash.
[[nodiscard]] std::uint64_t decisionHash(const FrameRequest& request, const visibility::VisibleSet& visible,
                                         const world::DynamicState& dynamics);

} // namespace limen::engine
