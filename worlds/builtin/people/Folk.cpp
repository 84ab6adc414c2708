#include "worlds/builtin/people/Folk.h"

#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/buildings/MeetingHall.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/people/FolkClothes.h"
#include "worlds/builtin/people/FolkModels.h"

#include <fmt/format.h>

namespace limen::worlds {

namespace {

using Json = nlohmann::ordered_json;

/// Metres. Routes are this high above the floor, so that a step over a sill is inside the opening and not on
/// its border.
constexpr double kAboveGround = 0.01;

/// Builds a route point by point.
class Route {
public:
    Route(const VillageMap& map, const char* name, bool loop) : map_(map) {
        json_["name"] = name;
        json_["loop"] = loop;
        json_["points"] = Json::array();
    }
    Route& inn(InnCell cell, double x, double y, double floor = 0.0) {
        return add(globalOf(map_.inn, {x, y, floor}), map_.innCells.at(static_cast<std::size_t>(cell)));
    }
    Route& hall(HallCell cell, double x, double y) {
        return add(globalOf(map_.hall, {x, y, 0.0}), map_.hallCells.at(static_cast<std::size_t>(cell)));
    }
    /// Adds a point outside on steps or boards, in a building's coordinates.
    Route& beside(const Placement& building, double x, double y, double floor) {
        return add(globalOf(building, {x, y, floor}), 0);
    }
    /// Adds a point on the ground, in coordinates of the village block.
    Route& ground(double x, double y) {
        return add(toGlobal({192.0 + x, 192.0 + y, landHeight(192.0 + x, 192.0 + y)}), 0);
    }
    [[nodiscard]] const Json& json() const { return json_; }

private:
    Route& add(const Vec3& at, dat::RecordId cell) {
        const auto rounded = [](double v) { return std::round(v * 1024.0) / 1024.0; };
        Json point;
        point["position"] = {rounded(at.x), rounded(at.y), rounded(at.z + kAboveGround)};
        point["cell"] = cell == 0 ? "outside" : fmt::format("0x{:08X}", cell);
        json_["points"].push_back(std::move(point));
        return *this;
    }

    const VillageMap& map_;
    Json json_;
};

constexpr double kYardBelow = -0.375; ///< metres, relative to the floors

/// Adds the steps at the inn's front door, from the hall down to the yard or back up.
void throughTheInnsDoor(Route& route, const VillageMap& map, bool out) {
    if (out) {
        route.inn(InnCell::Hall, 0.0, 1.2);
        route.beside(map.inn, 0.0, -0.05, 0.0);
        route.beside(map.inn, 0.0, -1.2, kYardBelow);
    } else {
        route.beside(map.inn, 0.0, -1.2, kYardBelow);
        route.beside(map.inn, 0.0, -0.05, 0.0);
        route.inn(InnCell::Hall, 0.0, 1.2);
    }
}

void throughTheHallsDoor(Route& route, const VillageMap& map, double y, bool out) {
    const double door = -hall::kHalfLength;
    if (out) {
        route.hall(HallCell::Nave, -4.4, y);
        route.beside(map.hall, door - 0.05, y, 0.0);
        route.beside(map.hall, door - 1.3, y, kYardBelow);
    } else {
        route.beside(map.hall, door - 1.3, y, kYardBelow);
        route.beside(map.hall, door - 0.05, y, 0.0);
        route.hall(HallCell::Nave, -4.4, y);
    }
}

/// The guest's route between the inn's tables and the meeting hall.
Json guestRoute(const VillageMap& map) {
    Route route(map, "guest", false);
    route.inn(InnCell::Hall, -1.6, 3.4).inn(InnCell::Hall, -0.9, 2.2);
    throughTheInnsDoor(route, map, true);
    route.ground(110.5, 97.0).ground(110.2, 92.4);
    throughTheHallsDoor(route, map, hall::kMiddle - 0.3, false);
    route.hall(HallCell::Nave, 1.4, hall::kMiddle - 0.3).hall(HallCell::Nave, 1.9, hall::kMiddle + 0.4);
    return route.json();
}

/// The innkeeper's round on the ground floor.
Json innkeeperRoute(const VillageMap& map) {
    Route route(map, "innkeeper", true);
    route.inn(InnCell::Hall, -3.4, 5.6)
        .inn(InnCell::Hall, -5.0, 5.6)
        .inn(InnCell::Kitchen, -5.0, 7.6)
        .inn(InnCell::Kitchen, -0.4, 7.6)
        .inn(InnCell::Kitchen, 0.5, 8.5)
        .inn(InnCell::Passage, 2.1, 8.5)
        .inn(InnCell::Passage, 2.1, 6.0)
        .inn(InnCell::Parlour, 2.3, 4.2)
        .inn(InnCell::Parlour, 2.9, 2.1)
        .inn(InnCell::Hall, 0.7, 2.1)
        .inn(InnCell::Hall, -1.4, 3.3)
        .inn(InnCell::Hall, -3.2, 3.7);
    return route.json();
}

/// The maid's route from the kitchen up the stairs, to the west room and to the balcony.
Json maidRoute(const VillageMap& map) {
    using namespace inn;
    Route route(map, "maid", false);
    route.inn(InnCell::Kitchen, -0.6, 8.2)
        .inn(InnCell::Kitchen, 0.6, 8.6)
        .inn(InnCell::Passage, 2.0, 8.6)
        .inn(InnCell::Passage, 2.0, 5.75)
        .inn(InnCell::Stairs, kUpX, 5.75)
        .inn(InnCell::Stairs, kUpX, kStairsFoot - 0.24)
        .inn(InnCell::Stairs, kUpX, kStairsHead, kUpper)
        .inn(InnCell::Stairs, kUpX, 10.25, kUpper)
        .inn(InnCell::Landing, 2.0, 10.25, kUpper)
        .inn(InnCell::Landing, 1.7, 2.3, kUpper)
        .inn(InnCell::Landing, -1.8, 2.3, kUpper)
        .inn(InnCell::WestRoom, -4.4, 2.3, kUpper)
        .inn(InnCell::Landing, -1.6, 2.3, kUpper)
        .inn(InnCell::Landing, 0.0, 1.3, kUpper)
        .beside(map.inn, 0.0, -0.8, kBalcony)
        .beside(map.inn, 1.3, -1.1, kBalcony);
    return route.json();
}

/// The elder's route from the apse through the arch, out of the hall and along its front.
Json elderRoute(const VillageMap& map) {
    Route route(map, "elder", false);
    const double y = hall::kMiddle + 0.45;
    route.hall(HallCell::Apse, 7.15, hall::kMiddle + 1.5)
        .hall(HallCell::Apse, 7.1, hall::kMiddle + 0.6)
        .hall(HallCell::Nave, 5.2, y);
    throughTheHallsDoor(route, map, y, true);
    route.ground(114.0, 92.6).ground(118.5, 93.6);
    return route.json();
}

/// The watchman's route through the village and around the inn's yard.
Json watchRoute(const VillageMap& map) {
    Route route(map, "watch", true);
    route.ground(76.0, 97.6)
        .ground(96.0, 98.4)
        .ground(108.4, 98.2)
        .ground(119.4, 99.4)
        .ground(119.6, 95.0)
        .ground(104.0, 93.4)
        .ground(84.0, 94.6);
    return route.json();
}

Json farmerRoute(const VillageMap& map) {
    Route route(map, "farm", true);
    route.ground(84.0, 99.8).ground(84.0, 92.2).ground(98.0, 95.0).ground(102.0, 100.6);
    return route.json();
}

/// The cart's route along the lane. It has a point at every vertex, because the slope changes there.
Json cartRoute(const VillageMap& map) {
    Route route(map, "cart", false);
    for (int x = 24; x <= 144; x += 24)
        route.ground(x, 96.0);
    return route.json();
}

Json villager(const char* name, dat::RecordId model, const char* route, double speed, double start) {
    Json json;
    json["name"] = name;
    json["model"] = fmt::format("0x{:08X}", model);
    json["route"] = route;
    json["speed"] = speed;
    json["start"] = start;
    return json;
}

Json worn(dat::RecordId table, std::uint32_t palette, double shade) {
    Json json;
    json["table"] = fmt::format("0x{:08X}", table);
    json["palette"] = palette;
    json["shade"] = shade;
    return json;
}

} // namespace

std::vector<Vec3> hallTorches() {
    const double wall = -hall::kHalfLength;
    return {{wall, hall::kMiddle - 2.2, 2.1}, {wall, hall::kMiddle + 2.2, 2.1}};
}

void addFolk(ModelWriter& writer, const Effects& effects, VillageMap& map) {
    const FolkModels models = addFolkModels(writer, effects);
    map.routes = {guestRoute(map), innkeeperRoute(map), maidRoute(map), elderRoute(map),
                  watchRoute(map), farmerRoute(map),    cartRoute(map)};
    map.villagers = {villager("guest", models.farmer, "guest", 1.3, 0.0),
                     villager("innkeeper", models.innkeeper, "innkeeper", 1.1, 4.0),
                     villager("maid", models.maid, "maid", 1.2, 2.0),
                     villager("elder", models.elder, "elder", 0.9, 0.0),
                     villager("watchman", models.watchman, "watch", 1.3, 20.0),
                     villager("farmer", models.farmer, "farm", 1.2, 30.0),
                     villager("carter", models.carter, "cart", 1.1, 40.0)};
    // The guest wears a dyed cloak, the traveller the same cloak undyed.
    map.villagers.front()["clothing"] = Json::array({worn(models.cloak, kDyed, 0.4)});
    map.player["clothing"] = Json::array({worn(models.cloak, kUndyed, 0.0)});
    map.villagers[4]["play"] = {{"kind", kWatchmansPlay}, {"intensity", 0.5}};
    map.player["model"] = fmt::format("0x{:08X}", models.traveller);
}

} // namespace limen::worlds
