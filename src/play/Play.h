#pragma once

#include "engine/Session.h"
#include "motion/DoorUse.h"
#include "play/PlayInput.h"
#include "play/RootTracker.h"
#include "play/WalkingBody.h"

namespace limen::play {

/// Somebody in a world: eye, body, doors, time and weather, moved on frame by frame. What it does depends on the session's world, the
/// start and the inputs alone, so that recorded inputs give the same frames again; each frame must be drawn before the next step.
class Play {
public:
    /// The session must outlive it. `residency`: what loads what comes near; null: the session itself, at once. It outlives it, too.
    Play(engine::Session& session, engine::FrameRequest start, engine::Residency* residency = nullptr);

    /// Errors: what is around a body cannot be read.
    [[nodiscard]] Result<void> step(const PlayInput& input);

    /// What the frame is to show.
    [[nodiscard]] const engine::FrameRequest& request() const { return request_; }
    [[nodiscard]] const WalkingBody& walk() const { return walk_; }
    /// The door that Act::Use would move, by its index.
    [[nodiscard]] std::optional<std::size_t> doorInReach() const { return door_; }
    /// The place that it is on its way to; empty: none.
    [[nodiscard]] std::string_view goingTo() const { return going_ ? std::string_view(going_->name) : ""; }
    [[nodiscard]] bool opens(std::size_t door) const {
        return doors_.opens(session_.part().world.doors[door]);
    }

private:
    struct Destination {
        engine::ViewRequest view;
        std::string name;
    };
    void act(const PlayAct& act);
    void beginToWalk();
    void swingDoors();
    void standDoors(double open);
    void useDoor();
    void goTo(std::size_t place);
    [[nodiscard]] Result<void> goOn();
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
    std::optional<double> doorsTowards_; ///< where all doors are swinging to, 0 or 1
    std::optional<std::size_t> door_;
    std::uint64_t steps_ = 0, framesAtStep_ = 0; ///< so far; Session::frames at the last one
    std::optional<Destination> going_;           ///< once it is shown
};

} // namespace limen::play
