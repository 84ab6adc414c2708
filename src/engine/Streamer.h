#pragma once

#include "core/Error.h"
#include "world/Loader.h"

#include <cstdint>
#include <optional>
#include <string>

// Which part of the world comes next, and when it is shown. It sets others to work, and knows no clock, thread or device.
namespace limen::engine {

/// A part of the world that is shown, or is to be.
struct StreamTarget {
    dat::BlockCoord centre;
    world::LoadOptions options;
    friend bool operator==(const StreamTarget&, const StreamTarget&) = default;
};

/// Where the eye is.
struct StreamEye {
    Vec3 position{0.0};    ///< global
    dat::BlockCoord block; ///< of its space: in a dungeon its position says nothing
    bool isAway = false;   ///< it waits to go there, and what is near that will not do
};

/// What a streamer has done for it, a little each frame. Nothing of it waits.
class StreamTasks {
public:
    virtual ~StreamTasks() = default;
    /// Begins to read a part of the world, on other threads.
    virtual void beginToRead(const StreamTarget& target) = 0;
    /// None: it still reads. Errors: nothing can be loaded there.
    [[nodiscard]] virtual std::optional<Result<void>> pollRead() = 0;
    /// Begins to upload what was read. Errors: the device's.
    [[nodiscard]] virtual Result<void> beginToUpload() = 0;
    /// A frame's share of uploading, and of freeing what is shown no more; also where nothing is coming. Yields true when what is
    /// coming can be shown. Errors: the device's; then what was coming is gone.
    [[nodiscard]] virtual Result<bool> advance() = 0;
    /// What was read, or is being uploaded, is not wanted.
    virtual void drop() = 0;
    /// What is coming is shown from now on.
    virtual void show() = 0;
};

class Streamer {
public:
    /// Metres that an eye goes beyond the block in the middle before the next part is read: who walks to and fro along a border has
    /// nothing read.
    static constexpr double kLeash = 24.0;

    /// The tasks must outlive it.
    explicit Streamer(StreamTasks& tasks) : tasks_(tasks) {}

    /// One frame. `shown`: what is, whoever has seen to that. True if the next part is shown from now on.
    bool step(const StreamTarget& shown, const StreamEye& eye, const world::LoadOptions& wanted);

    enum class Phase : std::uint8_t { Idle, Reading, Uploading };
    [[nodiscard]] Phase phase() const { return phase_; }
    /// What is read or uploaded. Only then.
    [[nodiscard]] const StreamTarget& coming() const { return coming_; }
    /// Whether it was what could not be loaded last.
    [[nodiscard]] bool hasFailed(const StreamTarget& target) const { return failed_ == target; }
    /// What could not be loaded, since this was asked last; each place once. Empty: nothing.
    [[nodiscard]] std::string takeFault();

private:
    [[nodiscard]] bool isWanted(const StreamTarget& shown, const StreamEye& eye,
                                const world::LoadOptions& wanted) const;
    void begin(const StreamTarget& target);
    void goOnReading(bool isWanted);
    bool goOnUploading(bool isWanted);
    void give(const Error& error);
    void drop();

    StreamTasks& tasks_;
    Phase phase_ = Phase::Idle;
    StreamTarget coming_;
    std::optional<StreamTarget> shown_;  ///< in the last frame
    bool isOutdated_ = false;            ///< what is being read follows what is not shown any more
    std::optional<StreamTarget> failed_; ///< not tried again, until something else was
    std::string fault_;
};

} // namespace limen::engine
