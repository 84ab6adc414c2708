#pragma once

#include "frame/FrameView.h"
#include "motion/DynamicStateBuilder.h"

#include <optional>
#include <vector>

namespace limen::engine {

using frame::Weather;
using world::Look;

/// The variable state of a scene: all inputs of a frame except the camera and the world's records.
struct SceneState {
    double time = 0.5;          ///< fraction of the day; 0 and 1 are midnight
    std::uint32_t dayGroup = 0; ///< index of the Region's day groups
    Weather weather = Weather::Clear;
    world::Look look = world::Look::Retail;
    double seconds = 0.0;        ///< since the start of the world; drives villagers, sprites and clouds
    std::optional<double> doors; ///< openness of all doors, 0..1; none: `eachDoor` applies
    std::vector<double>
        eachDoor;     ///< openness by World::doors, 0..1; doors beyond its end keep their initial openness
    Vec3 player{0.0}; ///< global, metres; ignored if there is a body
    std::optional<motion::PlayerBody> body; ///< the player's visible body
};

} // namespace limen::engine
