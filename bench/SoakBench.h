#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// An hour of walking, drawn as fast as possible: eight laps of the built-in world's tour in small pictures.
/// Only one block in each direction is loaded, so that blocks are loaded and freed all the time.
///
/// `soak/memory`: growth of resident memory in percent, from the second and third lap to the last two.
/// `soak/objects`: number of laps that end with other numbers of device objects, handles or buffer bytes than
/// the first. The scene has the figures themselves. No rows without OpenGL.
///
/// Takes some minutes with a software driver.
[[nodiscard]] std::vector<BenchRow> benchSoak(AllocationCounter counter = nullptr);

} // namespace limen::bench
