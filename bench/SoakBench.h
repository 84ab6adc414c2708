#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// An hour of walking, as fast as it can be drawn: the built-in world's tour eight times over, one block loaded each way, so that
/// blocks come and go all the time, in small pictures.
///
/// `soak/memory`: by how much the program's resident memory in the last two laps is above that in the second and third, in
/// percent. `soak/objects`: laps after the first that end with other numbers of device objects, handles or bytes of buffers
/// than the first. The scene tells the figures themselves. No rows without OpenGL.
///
/// Takes some minutes with a software driver.
[[nodiscard]] std::vector<BenchRow> benchSoak(AllocationCounter counter = nullptr);

} // namespace limen::bench
