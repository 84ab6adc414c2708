#include "engine/stream/Streamer.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace limen::engine {
namespace {

int blocksBetween(dat::BlockCoord a, dat::BlockCoord b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

/// An eye whose space is in the centre block is always covered. Its position does not count there, because a
/// dungeon's cells can have any coordinates.
bool covers(const PartTarget& target, const StreamEye& eye) {
    return target.centre == eye.block ||
           (blocksBetween(target.centre, eye.block) <= 1 &&
            world::metresBeside(target.centre, eye.position) <= Streamer::kLeash);
}

} // namespace

/// A coming part that no longer covers the eye is still shown if it is closer than the part on the screen.
/// Otherwise an eye that flies faster than parts load would never see a new one.
bool Streamer::isWanted(const PartTarget& shown, const StreamEye& eye,
                        const world::LoadOptions& wanted) const {
    if (!(coming_.options == wanted))
        return false;
    if (eye.isAway)
        return coming_.centre == eye.block;
    if (covers(coming_, eye))
        return true;
    const int away = blocksBetween(coming_.centre, eye.block);
    return away <= wanted.radius && away < blocksBetween(shown.centre, eye.block);
}

void Streamer::noteFailure(const Error& error) {
    if (failed_ != coming_)
        fault_ = error.message();
    failed_ = coming_;
    phase_ = Phase::Idle;
}

StreamCommand Streamer::continueReading(bool isWanted, const StreamProgress& progress) {
    if (!progress.isRead)
        return StreamCommand::None;
    if (progress.error) {
        noteFailure(*progress.error);
        return StreamCommand::None;
    }
    phase_ = isWanted ? Phase::Uploading : Phase::Idle;
    return isWanted ? StreamCommand::Upload : StreamCommand::Drop;
}

StreamCommand Streamer::continueUploading(bool isWanted, const StreamProgress& progress) {
    if (progress.error) {
        if (isWanted)
            noteFailure(*progress.error);
        phase_ = Phase::Idle;
        return StreamCommand::Drop;
    }
    if (!isWanted) {
        phase_ = Phase::Idle;
        return StreamCommand::Drop;
    }
    return progress.isUploaded ? StreamCommand::Offer : StreamCommand::None;
}

StreamCommand Streamer::step(const PartTarget& shown, const StreamEye& eye, const world::LoadOptions& wanted,
                             const StreamProgress& progress) {
    LIMEN_ASSERT(!progress.isRead || phase_ == Phase::Reading, "only a part that was requested can be read");
    LIMEN_ASSERT(!progress.isUploaded || phase_ == Phase::Uploading,
                 "only a part that was read can be uploaded");
    // If another caller has loaded a part, the coming scene is unusable: it was staged as the successor of
    // the old scene.
    const bool isAnother = shown_ && !(*shown_ == shown);
    shown_ = shown;
    const bool isStillWanted = !isAnother && !isOutdated_ && isWanted(shown, eye, wanted);
    isOutdated_ = (isOutdated_ || isAnother) && phase_ == Phase::Reading;
    last_ = StreamCommand::None;
    if (phase_ == Phase::Uploading)
        last_ = continueUploading(isStillWanted, progress);
    else if (phase_ == Phase::Reading)
        last_ = continueReading(isStillWanted, progress);
    else if (const PartTarget target{eye.block, wanted};
             !(shown.options == wanted && covers(shown, eye)) && failed_ != target) {
        coming_ = target;
        phase_ = Phase::Reading;
        last_ = StreamCommand::Read;
    }
    return last_;
}

void Streamer::shown() {
    LIMEN_ASSERT(last_ == StreamCommand::Offer, "only an offered part can be shown");
    last_ = StreamCommand::None;
    phase_ = Phase::Idle;
    failed_.reset();
    shown_ = coming_;
}

const PartTarget& Streamer::coming() const {
    LIMEN_ASSERT(phase_ != Phase::Idle, "a part is read or uploaded");
    return coming_;
}

std::string Streamer::takeFault() {
    return std::exchange(fault_, {});
}

} // namespace limen::engine
