#pragma once

#include "BenchRow.h"
#include "TwoWays.h"

namespace limen::bench {

/// Microseconds a frame for the renderer and the classic path. Each value is the mean over all views of one
/// repeat.
struct WayTimes {
    std::vector<double> real, classic;
    std::uint64_t allocations = 0; ///< of the renderer, over the last repeat
};

/// Processor time of this thread for planning and submission to the null device. The two paths take turns,
/// after two repeats to warm up. Dynamic objects are moved before each frame, outside of the timed span.
/// Errors: those of both paths.
[[nodiscard]] Result<WayTimes> timeOnNullDevice(ObjectField& field, std::span<const FieldView> views,
                                                int repeats, AllocationCounter counter);

/// Times of a driver's frames, and whether both paths show the same ids.
struct DriverRun {
    WayTimes calls;    ///< processor time of this thread until the calls return; the driver was idle before
    WayTimes finished; ///< wall-clock time until glFinish returns
    bool same = true;  ///< all pixels of all views have equal ids
    std::uint64_t hash = 0; ///< of the ids that the renderer draws
};

/// Times both paths with a driver, whose context must be current, and compares the ids of all views.
[[nodiscard]] Result<DriverRun> runOnDriver(gpu::Device& device, ObjectField& field,
                                            std::span<const FieldView> views, int repeats);

} // namespace limen::bench
