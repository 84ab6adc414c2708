#pragma once

#include "dat/Ids.h"
#include "demo/Models.h"

#include <nlohmann/json.hpp>
#include <string>

namespace limen::demo {

/// A standing eye: global metres, degrees; `cell` 0 means outside.
struct Eye {
    Vec3 position{0.0};
    double yaw = 0.0, pitch = 0.0;
    dat::RecordId cell = 0;
};

/// What the places are measured from: where the buildings stand (coordinates of the village block) and their
/// cells. The lists of what moves are as `world.json` has them (docs/world-file.md).
struct VillageMap {
    Placement cottage, neighbour, inn, hall;
    std::vector<dat::RecordId> cottageCells, neighbourCells, innCells, hallCells;
    nlohmann::ordered_json doors, routes, villagers, emitters;
};

/// A point of a building of the village, in global metres.
[[nodiscard]] Vec3 globalOf(const Placement& building, const Vec3& local);
/// An eye at a point that looks at another one; global metres.
[[nodiscard]] Eye eyeTowards(const Vec3& position, const Vec3& target, dat::RecordId cell);

/// A leg of the tour: to a point (on the ground below it, or straight through the air) at a speed in metres a second,
/// or standing and turning for some seconds; at its end the eye looks at `target`. Global metres.
struct TourStep {
    enum class Kind { AlongGround, Straight, Look };
    Kind kind = Kind::Straight;
    Vec3 to{0.0}, target{0.0};
    double pace = 1.8;
};

/// `world.json`: place names, the tour, and the map's lists of what moves.
[[nodiscard]] nlohmann::ordered_json buildWorldFile(const VillageMap& map);

} // namespace limen::demo
