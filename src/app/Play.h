#pragma once

#include "app/RootTracker.h"
#include "app/Session.h"
#include "app/Walk.h"
#include "motion/DoorUse.h"

#include <vector>

namespace limen::app {

/// What a person does once, in one frame. All but the last four are toggles.
struct PlayAct {
    enum class Kind : std::uint8_t {
        Walk,     ///< with a body, or without
        Chase,    ///< the eye behind the body, or in its head
        Doors,    ///< all open, or shut
        Use,      ///< opens the door in reach, or shuts it
        Weather,  ///< clear, or rain
        Place,    ///< goes to one of the world's places: `value` is its number
        Time,     ///< of day becomes `value`
        AllDoors, ///< stand open as far as `value`; less than 0: each as it was left
        Distance  ///< of the eye from the body's head: `value`, metres
    };
    Kind kind = Kind::Walk;
    double value = 0.0;
    friend bool operator==(const PlayAct&, const PlayAct&) = default;
};

/// What a person does during one frame.
struct PlayInput {
    double seconds = 0.0;                        ///< since the last frame
    double forward = 0.0, right = 0.0, up = 0.0; ///< -1..1 each
    double turnRight = 0.0, turnUp = 0.0;        ///< degrees
    bool fast = false, jump = false;
    bool isFrozen = false; ///< the world stands still; the eye may move
    PixelSize size;        ///< of the picture
    std::vector<PlayAct> acts;
    friend bool operator==(const PlayInput&, const PlayInput&) = default;
};

/// Somebody in a world: eye, body, doors, time and weather, moved on frame by frame. What it does depends on the session's world, the
/// start and the inputs alone, so that recorded inputs give the same frames again; each frame must be drawn before the next step.
class Play {
public:
    /// The session must outlive it.
    Play(Session& session, FrameEye start);

    /// Errors: what is around a body cannot be read.
    [[nodiscard]] Result<void> step(const PlayInput& input);

    /// What the frame is to show.
    [[nodiscard]] const FrameEye& eye() const { return eye_; }
    [[nodiscard]] const Walk& walk() const { return walk_; }
    /// The door that Act::Use would move, by its index.
    [[nodiscard]] std::optional<std::size_t> doorInReach() const { return door_; }
    [[nodiscard]] bool opens(std::size_t door) const {
        return doors_.opens(session_.loaded().world.doors[door]);
    }

private:
    void act(const PlayAct& act);
    void beginToWalk();
    void swingDoors();
    void standDoors(double open);
    void useDoor();
    void goTo(std::size_t place);
    [[nodiscard]] Result<void> moveEye(const PlayInput& input);
    void moveDoors(double seconds);
    void findDoor();

    Session& session_;
    FrameEye eye_;
    RootTracker tracker_;
    Walk walk_;
    motion::DoorUse doors_;
    std::optional<double> doorsTowards_; ///< where all doors are swinging to, 0 or 1
    std::optional<std::size_t> door_;
};

} // namespace limen::app
