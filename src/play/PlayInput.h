#pragma once

#include "engine/Camera.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limen::play {

/// The kinds of one-shot actions.
enum class PlayActKind : std::uint8_t {
    Walk,     ///< switch between walking with a body and flying
    Chase,    ///< switch between third person and first person
    Doors,    ///< open all doors, or close them
    Use,      ///< open the door in reach, or close it; else go through the travel portal in reach
    Weather,  ///< switch between clear and rain
    Place,    ///< go to one of the world's places: `value` is its index
    Time,     ///< set the time of day to `value`
    AllDoors, ///< set the openness of all doors to `value`; below 0: each door keeps its own
    Distance, ///< set the distance of a third-person camera to `value` metres
    Quality,  ///< choose a quality level: `value` is an index of engine::kQualities
    Day,      ///< choose a day group: `value` is its index in the Region
    Fov,      ///< set the vertical field of view to `value` degrees
    Go,       ///< go to the ground at a point of the map: `value` and `north` are metres, global
    Look,     ///< 0: as the original draws; 1: world::Look::Enhanced
    Object    ///< go before a placed object: `value` is its guid in the world.db
};

/// A one-shot action of the player, in one frame.
struct PlayAct {
    static constexpr std::size_t kKinds = 15;
    PlayActKind kind = PlayActKind::Walk;
    double value = 0.0;
    double north = 0.0; ///< of Go: metres from the map's south-west corner; `value` is the metres to the east
    friend bool operator==(const PlayAct&, const PlayAct&) = default;
};

/// The player's input of one frame.
struct PlayInput {
    double seconds = 0.0;                        ///< since the last frame
    double forward = 0.0, right = 0.0, up = 0.0; ///< -1..1 each
    double turnRight = 0.0, turnUp = 0.0;        ///< degrees
    bool fast = false, jump = false;
    bool isFrozen = false;  ///< world time stops; the eye can move
    engine::PixelSize size; ///< of the picture
    std::vector<PlayAct> acts;
    friend bool operator==(const PlayInput&, const PlayInput&) = default;
};

} // namespace limen::play
