#pragma once

#include "gpu/device/Device.h"
#include "gpu/device/GlObjects.h"

namespace limen::gpu {

/// Timestamps around every stage, read some frames later without waiting. A frame whose set of queries is
/// still in flight four frames later is not timed.
class StageTimers {
public:
    StageTimers();

    void beginFrame();
    void begin(frame::StageKind stage);
    void end(frame::StageKind stage);
    /// Takes what has arrived and yields the latest times known.
    [[nodiscard]] StageTimes poll();

private:
    static constexpr std::size_t kFrames = 4;
    struct Pair {
        Query begin, end;
        bool inFlight = false;
    };
    using FrameQueries = std::array<Pair, frame::kStageCount>;

    std::array<FrameQueries, kFrames> frames_;
    std::size_t current_ = 0;
    StageTimes latest_{};
};

} // namespace limen::gpu
