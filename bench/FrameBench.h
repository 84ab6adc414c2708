#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures whole frames along the built-in world's tour at 1280×720. They are compared with frames of the
/// same program that draw, like a renderer without visibility, all spaces in the frustum.
///
/// `frame/cpu`: processor time of this thread on the null device, from the dynamic state to the last call,
/// median over all way points. `frame/indoors`, `frame/town`: wall-clock time with a driver until the GPU has
/// finished, mean over some way points in cells and outside. `frame/ownership`: the share of these frames'
/// time, in percent, of the ownership stage and the ownership tests; frames with and without them take turns.
///
/// Without OpenGL there is only the first row. Takes some minutes with a software driver. Writes the built-in
/// world to the system's temporary directory and removes it.
[[nodiscard]] std::vector<BenchRow> benchFrame(AllocationCounter counter = nullptr);

} // namespace limen::bench
