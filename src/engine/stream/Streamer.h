#pragma once

#include "core/Error.h"
#include "engine/LoadedPart.h"

#include <cstdint>
#include <optional>
#include <string>

// Decides which part of the world is loaded next and when it is shown. A state machine without clock, threads
// and device: the caller reports the progress of the work, and gets a command to carry out
// (StreamedResidency.h does so).
namespace limen::engine {

/// Position and destination of the eye.
struct StreamEye {
    Vec3 position{0.0};    ///< global, metres
    dat::BlockCoord block; ///< of the eye's space; positions in a dungeon do not determine their block
    bool isAway = false;   ///< the eye waits for `block` (a teleport); a neighbouring block does not do
};

/// Progress of the work on the coming part since the last command.
struct StreamProgress {
    bool isRead = false;        ///< reading has ended; with success unless there is an error
    bool isUploaded = false;    ///< the upload has ended
    std::optional<Error> error; ///< of reading or uploading; the part is dropped already
};

/// The next action of the engine.
enum class StreamCommand : std::uint8_t {
    None,
    Read,   ///< start to read Streamer::coming() on other threads
    Upload, ///< start to upload the part that was read
    Drop,   ///< drop the part that was read or is being uploaded
    Offer   ///< the coming part is uploaded; show it when its users are ready
};

class Streamer {
public:
    /// Hysteresis in metres: the next block loads only when the eye is this far beyond the centre block.
    static constexpr double kLeash = 24.0;

    /// Call it once a frame. `shown`: the part currently drawn; another caller may have changed it. `wanted`:
    /// the loading options for the next part. `progress`: see StreamProgress.
    [[nodiscard]] StreamCommand step(const PartTarget& shown, const StreamEye& eye,
                                     const world::LoadOptions& wanted, const StreamProgress& progress);
    /// Reports that the offered part is shown. Requires Offer as the last command.
    void shown();

    enum class Phase : std::uint8_t { Idle, Reading, Uploading };
    [[nodiscard]] Phase phase() const { return phase_; }
    /// The part that is read or uploaded. Requires a phase other than Idle.
    [[nodiscard]] const PartTarget& coming() const;
    /// Whether this is the part that failed last.
    [[nodiscard]] bool hasFailed(const PartTarget& target) const { return failed_ == target; }
    /// The message of the failure since the last call; empty: none. A part that fails repeatedly is reported
    /// once.
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
    bool isOutdated_ = false;          ///< the part being read was started for a part that is no longer shown
    std::optional<PartTarget> failed_; ///< not tried again until another part was shown or failed
    std::string fault_;
};

} // namespace limen::engine
