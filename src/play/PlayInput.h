#pragma once

#include "cli/Parse.h"

#include <cstdint>
#include <vector>

namespace limen::play {

/// What a person does once, in one frame.
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
        Distance, ///< of the eye from the body's head: `value`, metres
        engine::Quality,  ///< of kQualities: `value` is its number
        Day       ///< of the Region's day groups: `value` is its number
    };
    static constexpr std::size_t kKinds = 11;
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
    cli::PixelSize size;        ///< of the picture
    std::vector<PlayAct> acts;
    friend bool operator==(const PlayInput&, const PlayInput&) = default;
};

} // namespace limen::play
