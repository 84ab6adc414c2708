#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Whole frames along the built-in world's tour, 1280×720, beside frames of the same program with what a renderer without
/// visibility draws: every space within the picture's edges.
///
/// `frame/cpu`: from moving to the last call, on the null device, processor time of this thread; the median over all way
/// points. `frame/indoors`, `frame/town`: with a driver, until the GPU is done, the clock on the wall; the mean over some way
/// points within cells and outside. `frame/ownership`: of these frames, in percent, what the ownership stage and the tests for it
/// take: with them and without, in turn. Only the first row without OpenGL.
///
/// Takes some minutes with a software driver; writes the built-in world to the system's temporary directory meanwhile.
[[nodiscard]] std::vector<BenchRow> benchFrame(AllocationCounter counter = nullptr);

} // namespace limen::bench
