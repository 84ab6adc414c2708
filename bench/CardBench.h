#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures GPU time on a graphics card: 64 way points of the built-in world's tour at 1280×720, 2560×1440 and
/// 3840×2160, by both ways of drawing, with bindless textures and array pages, and `exact` without parts of it.
/// Without a card there is one row without a value. Takes some minutes. Writes the built-in world to the system's
/// temporary directory and removes it.
[[nodiscard]] std::vector<BenchRow> benchCard(AllocationCounter counter = nullptr);

} // namespace limen::bench
