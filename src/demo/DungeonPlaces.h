#pragma once

#include "demo/DungeonBlocks.h"
#include "demo/Places.h"

namespace limen::demo {

/// A part of the tour, walked with the eye turning towards `target` (global).
struct TourLeg {
    enum class Kind {
        Ground,   ///< along the ground, to x and y of `to`
        Straight, ///< through the air
        Flight,   ///< the same, in wide strides
        Look      ///< stands and turns, for `speed` seconds
    };
    Kind kind = Kind::Straight;
    Vec3 to{0.0}; ///< area coordinates
    double speed = 1.5;
    Vec3 target{0.0}; ///< global
};

/// Places of tower, cave and dungeons, in the order of their names in `world.json`.
[[nodiscard]] std::vector<std::pair<std::string, Eye>> dungeonPlaces(const DungeonMap& map);
/// From the lane up to the tower and its roof, to the cave, down to the hub and the pit.
[[nodiscard]] std::vector<TourLeg> dungeonTour(const DungeonMap& map);
/// Sparks of braziers.
[[nodiscard]] nlohmann::ordered_json dungeonEmitters(const DungeonMap& map);

} // namespace limen::demo
