#pragma once

#include "frame/FrameView.h"
#include "motion/DynamicStateBuilder.h"

#include <optional>
#include <vector>

namespace limen::engine {

using frame::Weather;

/// The changing part of a scene: everything that a frame shows beside the camera and the world's records.
struct SceneState {
    double time = 0.5;          ///< fraction of the day, 0 and 1 are midnight
    std::uint32_t dayGroup = 0; ///< index of the Region's day groups
    Weather weather = Weather::Clear;
    double seconds = 0.0;        ///< since the world began; moves villagers, sprites and clouds
    std::optional<double> doors; ///< openness of all doors, 0..1; none: `eachDoor` counts
    std::vector<double>
        eachDoor;     ///< openness by World::doors; doors beyond its end keep their resting openness
    Vec3 player{0.0}; ///< global; ignored if there is a body
    std::optional<motion::PlayerBody> body; ///< the player's visible body
};

} // namespace limen::engine
