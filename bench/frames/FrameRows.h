#pragma once

#include "BenchRow.h"
#include "frames/FrameTimes.h"
#include "frames/LimenWays.h"

#include <span>

namespace limen::bench {

/// Largest share of the peer's time that a frame may take.
inline constexpr double kMostOfPeerInCells = 0.5, kMostOfPeerOutside = 0.8, kMostOfPeerAtAPlace = 1.0;

/// The rows of a comparison. Each has a twin: wall-clock and processor time.
///
/// `frame/RENDERER/cells/...`, `frame/RENDERER/outside/...`: the mean over the places of that kind, with p95
/// over them; a row for each renderer. `frame/places/NUMBER/...`: the first renderer at one place.
/// Against: every other way but those without ownership. Only rows of the first renderer have targets, and
/// only if the peer was drawn.
[[nodiscard]] std::vector<BenchRow> rowsOf(const FrameTimes& times, std::span<const LimenRenderer> renderers);

/// The share of a frame's processor time, in percent, that ownership takes, over all places.
[[nodiscard]] BenchRow ownershipRow(const FrameTimes& times, const std::string& renderer);

} // namespace limen::bench
