#include "gpu/device/StageTimers.h"

namespace limen::gpu {

StageTimers::StageTimers() {
    for (FrameQueries& queries : frames_) {
        for (Pair& pair : queries) {
            pair.begin = Query::createTimestamp("stage begin");
            pair.end = Query::createTimestamp("stage end");
        }
    }
}

void StageTimers::beginFrame() {
    (void)poll();
    current_ = (current_ + 1) % kFrames;
}

void StageTimers::begin(frame::StageKind stage) {
    Pair& pair = frames_[current_][static_cast<std::size_t>(stage)];
    if (!pair.inFlight)
        pair.begin.stamp();
}

void StageTimers::end(frame::StageKind stage) {
    Pair& pair = frames_[current_][static_cast<std::size_t>(stage)];
    if (!pair.inFlight) {
        pair.end.stamp();
        pair.inFlight = true;
    }
}

StageTimes StageTimers::poll() {
    for (std::size_t age = kFrames; age-- > 0;) { // oldest first, so that the latest remains
        FrameQueries& queries = frames_[(current_ + kFrames - age) % kFrames];
        for (std::size_t stage = 0; stage < queries.size(); ++stage) {
            Pair& pair = queries[stage];
            if (!pair.inFlight)
                continue;
            const std::optional<std::uint64_t> end = pair.end.poll();
            const std::optional<std::uint64_t> begin = pair.begin.poll();
            if (begin && end) {
                latest_[stage] = static_cast<double>(*end - *begin) * 1e-6;
                pair.inFlight = false;
            }
        }
    }
    return latest_;
}

} // namespace limen::gpu
