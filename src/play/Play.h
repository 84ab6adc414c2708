#pragma once

#include "engine/Session.h"
#include "motion/DoorUse.h"
#include "play/PlayInput.h"
#include "play/RootTracker.h"
#include "play/WalkingBody.h"

namespace limen::play {

/// The state of a player in a world: eye, body, doors, time and weather, advanced frame by frame. It depends
/// only on the session's world, the start and the inputs, so that recorded inputs reproduce the frames.
/// Requires that each frame is drawn before the next step.
class Play {
public:
    /// `residency` loads the blocks that come near; null: the session loads them at once. Both must outlive
    /// the Play.
    Play(engine::Session& session, engine::FrameRequest start, engine::Residency* residency = nullptr);

    /// Errors: the solids around the body cannot be read.
    [[nodiscard]] Result<void> step(const PlayInput& input);

    /// The request of the current frame.
    [[nodiscard]] const engine::FrameRequest& request() const { return request_; }
    [[nodiscard]] const WalkingBody& walk() const { return walk_; }
    /// The index of the door that PlayActKind::Use would move.
    [[nodiscard]] std::optional<std::size_t> doorInReach() const { return door_; }
    /// Whether the door in reach was used within the last two seconds, and stayed shut because it is locked.
    [[nodiscard]] bool isRefused() const;
    /// The name of the place that is loading as the destination; empty: none.
    [[nodiscard]] std::string_view goingTo() const { return going_ ? std::string_view(going_->name) : ""; }
    [[nodiscard]] bool opens(std::size_t door) const {
        return doors_.opens(session_.part().world.doors[door]);
    }

private:
    struct Destination {
        engine::ViewRequest view;
        std::string name;
    };
    /// The use of a locked door.
    struct Refusal {
        std::size_t door = 0;
        double seconds = 0.0; ///< the world's time
    };
    void act(const PlayAct& act);
    void beginToWalk();
    void swingDoors();
    void standDoors(double open);
    void useDoor();
    void useTravel();
    void goTo(std::size_t place);
    void goTo(const Vec2& point);
    void goToObject(double guid);
    [[nodiscard]] Result<void> travel();
    void standAt(engine::ViewRequest view);
    [[nodiscard]] Result<void> moveEye(const PlayInput& input);
    [[nodiscard]] Result<void> followEye();
    void moveDoors(double seconds);
    void swingAllTo(double open);
    void findDoor();

    engine::Session& session_;
    engine::Residency& residency_;
    engine::FrameRequest request_;
    RootTracker tracker_;
    WalkingBody walk_;
    motion::DoorUse doors_;
    std::optional<double> doorsTowards_; ///< the openness that all doors swing to, 0 or 1
    std::optional<std::size_t> door_;
    std::optional<Refusal> refusal_;             ///< the last one in this part of the world
    std::uint64_t steps_ = 0, framesAtStep_ = 0; ///< number of steps; Session::frames at the last step
    std::optional<Destination> going_;           ///< set until its part of the world is shown
};

} // namespace limen::play
