#pragma once

#include "BenchRow.h"
#include "TwoWays.h"

namespace limen::bench {

/// Microseconds a frame, of both ways: each the mean over all views, once for each repeat.
struct WayTimes {
    std::vector<double> real, classic;
    std::uint64_t allocations = 0; ///< of the renderer's way, over the last repeat
};

/// Processor time of this thread for planning and submitting to the null device, the two ways in turn, after two repeats to warm
/// up. What moves is moved before each frame, which is not timed. Errors: what the two ways report.
[[nodiscard]] Result<WayTimes> timeOnNullDevice(ObjectField& field, std::span<const FieldView> views,
                                                int repeats, AllocationCounter counter);

/// What a driver's frames take, and whether they show the same.
struct DriverRun {
    WayTimes calls;    ///< until the calls return, processor time of this thread; the driver was idle before
    WayTimes finished; ///< until glFinish returns, by the clock on the wall
    bool same = true;  ///< ids, to the pixel, from all views
    std::uint64_t hash = 0; ///< of the ids drawn the renderer's way
};

/// The same with a driver, whose context is current, and with ids read from every view.
[[nodiscard]] Result<DriverRun> runOnDriver(gpu::Device& device, ObjectField& field,
                                            std::span<const FieldView> views, int repeats);

} // namespace limen::bench
