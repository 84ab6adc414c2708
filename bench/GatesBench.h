#pragma once

#include "BenchRow.h"
#include "gates/GateTimes.h"

namespace limen::bench {

/// Rows of one way of drawing, named "gates/WAY/GATE/FIGURE": time, GL calls, draws, fragments and rectangles of each
/// gate, the mean over the places with the 95th percentile over them. Against: the other gates.
[[nodiscard]] std::vector<BenchRow> gateRows(const GateFrames& frames, const std::string& way);

/// Compares the gates (docs/gates.md) at 64 way points of the built-in world's tour, at 640×360, by both ways of
/// drawing. Writes the built-in world to the system's temporary directory and removes it.
[[nodiscard]] std::vector<BenchRow> benchGates(AllocationCounter counter = nullptr);
/// The same at 64 way points of the tour through the world in a directory. A world without world.json gets a tour.
[[nodiscard]] std::vector<BenchRow> benchGatesOver(const std::string& dat);

} // namespace limen::bench
