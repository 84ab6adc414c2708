#pragma once

#include "app/Session.h"
#include "motion/Body.h"

#include <future>

namespace limen::app {

/// What the hands ask of a walking body during one frame.
struct WalkInput {
    double forward = 0.0, right = 0.0; ///< -1..1 each
    bool run = false, jump = false;
    double seconds = 0.0; ///< since the last frame
};

/// A body under the eye of a window: it walks through what a session has loaded, and the eye goes with it. What it bumps into is
/// read anew when it comes into another landblock, by a thread of its own.
class Walk {
public:
    /// Puts the body under an eye. Waits for what is around it to be read. Errors: that cannot be.
    [[nodiscard]] Result<void> begin(const Session& session, const FrameEye& eye);
    /// No body any more.
    void end();
    [[nodiscard]] bool isOn() const { return isOn_; }

    /// Moves the body, and eye, player and root of `eye` with it. When the session has loaded another part of the world it is there as it
    /// was here. Requires a body. Errors: as begin's.
    [[nodiscard]] Result<void> step(const Session& session, const WalkInput& input, FrameEye& eye);

    [[nodiscard]] const motion::BodyState& body() const { return body_; }

private:
    /// The solids of a part of the world that is loaded.
    struct Surroundings {
        std::shared_ptr<const LoadedWorld> loaded;
        motion::Collisions collisions;
    };
    using Reading = Result<std::shared_ptr<const Surroundings>>;

    [[nodiscard]] static Reading read(const std::shared_ptr<const WorldSource>& source,
                                      std::shared_ptr<const LoadedWorld> loaded, dat::BlockCoord centre);
    /// Into the world that is loaded now, from one that was.
    void follow(const LoadedWorld& before, const LoadedWorld& now);
    [[nodiscard]] Result<void> keepSurroundings(const Session& session);
    [[nodiscard]] dat::BlockCoord blockOfBody(const LoadedWorld& loaded) const;
    void carryEye(const LoadedWorld& loaded, double fellOrRose, double seconds, FrameEye& eye);

    bool isOn_ = false;
    motion::BodyState body_;
    motion::BodyShape shape_;
    double lag_ = 0.0; ///< metres that the eye is still above where it belongs: it climbs steps smoothly
    std::shared_ptr<const Surroundings> around_;
    std::future<Reading> coming_;
    dat::BlockCoord comingCentre_;
};

} // namespace limen::app
