#pragma once

#include "core/Error.h"
#include "engine/LoadedPart.h"

#include <cstdint>
#include <optional>
#include <string>

// Which part of the world comes next, and when it is shown: a state machine that knows no clock, thread or device. It is told how
// far the work has come, and returns a command; the engine carries the command out (StreamedResidency.h).
namespace limen::engine {

/// Position of the eye.
struct StreamEye {
    Vec3 position{0.0};    ///< global
    dat::BlockCoord block; ///< of its space: positions in a dungeon's cells do not name their block
    bool isAway = false;   ///< it waits to go to `block`; a neighbouring block does not serve
};

/// How far the work on the coming part has got since the last command.
struct StreamProgress {
    bool isRead = false;        ///< reading has ended, well unless there is an error
    bool isUploaded = false;    ///< the upload has ended
    std::optional<Error> error; ///< of reading or uploading; nothing of the part is left
};

/// What the engine does next.
enum class StreamCommand : std::uint8_t {
    None,
    Read,   ///< begin to read Streamer::coming() on other threads
    Upload, ///< begin to upload the part that was read
    Drop,   ///< forget the part that was read or is being uploaded
    Offer   ///< the coming part is uploaded: show it as soon as its users are ready
};

class Streamer {
public:
    /// Hysteresis in metres: the next block loads only when the eye is this far beyond the centre block.
    static constexpr double kLeash = 24.0;

    /// One frame. `shown`: the part currently drawn; another caller may have changed it.
    [[nodiscard]] StreamCommand step(const PartTarget& shown, const StreamEye& eye,
                                     const world::LoadOptions& wanted, const StreamProgress& progress);
    /// The offered part is shown from now on. Requires the last command to be Offer.
    void shown();

    enum class Phase : std::uint8_t { Idle, Reading, Uploading };
    [[nodiscard]] Phase phase() const { return phase_; }
    /// The part that is read or uploaded. Requires another phase than Idle.
    [[nodiscard]] const PartTarget& coming() const;
    /// Whether this part was the last that failed.
    [[nodiscard]] bool hasFailed(const PartTarget& target) const { return failed_ == target; }
    /// The failure since the last call, each place once; empty: none.
    [[nodiscard]] std::string takeFault();

private:
    [[nodiscard]] bool isWanted(const PartTarget& shown, const StreamEye& eye,
                                const world::LoadOptions& wanted) const;
    [[nodiscard]] StreamCommand continueReading(bool isWanted, const StreamProgress& progress);
    [[nodiscard]] StreamCommand continueUploading(bool isWanted, const StreamProgress& progress);
    void noteFailure(const Error& error);

    Phase phase_ = Phase::Idle;
    StreamCommand last_ = StreamCommand::None;
    PartTarget coming_;
    std::optional<PartTarget> shown_;  ///< in the last frame
    bool isOutdated_ = false;          ///< the part being read follows a part that is not shown any more
    std::optional<PartTarget> failed_; ///< not tried again until another part was
    std::string fault_;
};

} // namespace limen::engine
