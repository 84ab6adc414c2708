#include "engine/Streamer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace limen::engine {
namespace {

int blocksBetween(dat::BlockCoord a, dat::BlockCoord b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

/// An eye in the block itself is at home wherever it is: cells of a dungeon may lie anywhere.
bool isAtHome(const StreamTarget& target, const StreamEye& eye) {
    return target.centre == eye.block ||
           (blocksBetween(target.centre, eye.block) <= 1 &&
            world::metresBeside(target.centre, eye.position) <= Streamer::kLeash);
}

} // namespace

/// Whether what is coming is still of use: else nobody who moves faster than it comes would ever see anything new.
bool Streamer::isWanted(const StreamTarget& shown, const StreamEye& eye,
                        const world::LoadOptions& wanted) const {
    if (!(coming_.options == wanted))
        return false;
    if (eye.isAway)
        return coming_.centre == eye.block;
    if (isAtHome(coming_, eye))
        return true;
    const int away = blocksBetween(coming_.centre, eye.block);
    return away <= wanted.radius && away < blocksBetween(shown.centre, eye.block);
}

void Streamer::begin(const StreamTarget& target) {
    coming_ = target;
    phase_ = Phase::Reading;
    tasks_.beginToRead(target);
}

void Streamer::drop() {
    tasks_.drop();
    phase_ = Phase::Idle;
}

void Streamer::give(const Error& error) {
    if (failed_ != coming_)
        fault_ = error.message();
    failed_ = coming_;
    phase_ = Phase::Idle;
}

void Streamer::goOnReading(bool isWanted) {
    const std::optional<Result<void>> read = tasks_.pollRead();
    if (!read)
        return;
    if (!*read)
        return give(read->error());
    if (!isWanted)
        return drop();
    phase_ = Phase::Uploading;
    if (const Result<void> begun = tasks_.beginToUpload(); !begun)
        give(begun.error());
}

bool Streamer::goOnUploading(bool isWanted) {
    if (!isWanted) {
        drop();
        return false;
    }
    const Result<bool> isThere = tasks_.advance();
    if (!isThere) {
        give(isThere.error());
        return false;
    }
    if (!*isThere)
        return false;
    tasks_.show();
    phase_ = Phase::Idle;
    failed_.reset();
    shown_ = coming_;
    return true;
}

bool Streamer::step(const StreamTarget& shown, const StreamEye& eye, const world::LoadOptions& wanted) {
    const bool isAnother =
        shown_ && !(*shown_ == shown); // somebody else has loaded: what comes was made to follow what is gone
    shown_ = shown;
    const bool isStillWanted = !isAnother && !isOutdated_ && isWanted(shown, eye, wanted);
    isOutdated_ = (isOutdated_ || isAnother) && phase_ == Phase::Reading;
    if (phase_ == Phase::Uploading)
        return goOnUploading(isStillWanted);
    if (phase_ == Phase::Reading)
        goOnReading(isStillWanted);
    else if (const StreamTarget target{eye.block, wanted};
             !(shown.options == wanted && isAtHome(shown, eye)) && failed_ != target)
        begin(target);
    if (phase_ != Phase::Uploading)
        static_cast<void>(tasks_.advance()); // nothing comes; it frees what is shown no more
    return false;
}

std::string Streamer::takeFault() {
    return std::exchange(fault_, {});
}

} // namespace limen::engine
