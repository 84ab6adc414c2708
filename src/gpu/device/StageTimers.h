#pragma once

#include "gpu/device/Device.h"
#include "gpu/device/GlObjects.h"

namespace limen::gpu {

/// Timestamps around every stage, read some frames later without waiting. A frame is not timed if its set of
/// queries is still in use by the frame four before.
class StageTimers {
public:
    StageTimers();

    void beginFrame();
    void begin(frame::StageKind stage);
    void end(frame::StageKind stage);
    /// Reads available results and yields the latest times.
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
