#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "geometry/Vec.h"
#include "world/PlacedEntry.h"

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

// The entries of world.json for dynamic objects (docs/world-file.md), with ids and names that are not
// resolved yet. Lengths in metres, times in seconds, angles in degrees.
namespace limen::world {

struct LeafEntry {
    dat::RecordId model = 0;
    Vec3 position{0.0};
    double yaw = 0.0, swing = 0.0;
    dat::RecordId motionTable =
        0; ///< that opens the model as the swing does, for rows of a database; 0: none
};

struct DoorEntry {
    std::string name;
    dat::RecordId cell = 0;
    std::uint32_t portal = 0; ///< index in the cell's portal list
    bool opaque = true;
    double open = 0.0;
    std::vector<LeafEntry> leaves;
};

struct RouteEntry {
    struct Point {
        Vec3 position{0.0};
        dat::RecordId cell = 0;
    };
    std::string name;
    bool loop = false;
    std::vector<Point> points;
};

struct VillagerEntry {
    std::string name, route;
    dat::RecordId model = 0;
    double speed = 1.0, start = 0.0;
    PlayEntry play;                      ///< of the Setup's table
    std::vector<ClothingEntry> clothing; ///< later entries cover earlier ones
    dat::RecordId basePalette = 0;       ///< of all indexed pictures of the body; 0: each has its own
};

struct EmitterEntry {
    std::string name, attachedTo;
    dat::RecordId surface = 0, cell = 0;
    Vec3 position{0.0}, velocity{0.0}, acceleration{0.0};
    double rate = 1.0, life = 1.0, spread = 0.0, radius = 0.0;
    std::array<double, 2> size{0.1, 0.1}, alpha{1.0, 1.0};
    std::uint32_t seed = 0;
};

struct MovingEntries {
    std::vector<DoorEntry> doors;
    std::vector<RouteEntry> routes;
    std::vector<VillagerEntry> villagers;
    std::vector<EmitterEntry> emitters;
    std::vector<PlacedEntry> placed; ///< of a world database, not of world.json
    dat::RecordId player = 0;        ///< model of the player's body; 0: it is not drawn
    std::vector<ClothingEntry> playerClothing;
    dat::RecordId playerPalette = 0; ///< as VillagerEntry::basePalette
    bool rain = false;               ///< whether it rains at the start
};

/// Reads the dynamic objects of a world file. `file`: its name, for error messages. Errors: a malformed
/// entry.
[[nodiscard]] Result<MovingEntries> readMovingEntries(const nlohmann::json& world, const std::string& file);

} // namespace limen::world
