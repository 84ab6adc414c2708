#pragma once

#include "geometry/Vec.h"
#include "motion/PartPoses.h"
#include "world/Index.h"
#include "world/Sky.h"

#include <optional>
#include <span>

namespace limen::motion {

/// The player's body: where it is, how it moves and how opaque it is drawn.
struct PlayerBody {
    Vec3 feet{0.0};                            ///< global
    double yaw = 0.0;                          ///< compass direction that the body faces, degrees
    world::SpaceIndex space = world::kOutside; ///< that the body's middle is in
    double opacity = 1.0;                      ///< 0: not drawn .. 1: solid
    double speed = 0.0;                        ///< metres a second on foot; 0: the body stands
    double metres = 0.0;                       ///< walked so far: selects the point of the stride
    friend bool operator==(const PlayerBody&, const PlayerBody&) = default;
};

/// Everything that a dynamic state depends on, beside the world.
struct DynamicStateInput {
    double seconds = 0.0; ///< since the world began; routes, cycles and particles follow it
    /// Openness of each door, 0..1, by World::doors; doors beyond the end have the world file's openness.
    std::span<const double> doors;
    std::optional<double> allDoors;                      ///< one openness for all doors; overrides `doors`
    BetweenFrames between = BetweenFrames::Interpolated; ///< of every animation
    bool rain = false; ///< draw rain; only while the player is outside (docs/ray-rule.md)
    /// Draw the Region's weather of this hour; only while the player is outside.
    std::optional<world::SkyHour> weather;
    std::optional<PlayerBody> player;                   ///< none: no body is drawn
    Vec3 eye{0.0};                                      ///< global; weather falls around it
    world::LevelShare levels;                           ///< of distances of levels of detail
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0}; ///< axes of the eye, which sprites face
};

} // namespace limen::motion
