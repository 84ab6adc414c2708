#include "worlds/builtin/places/Places.h"

#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/dungeon/DungeonPlaces.h"
#include "worlds/builtin/effects/Emitters.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/places/EastPlaces.h"
#include "worlds/builtin/places/Tour.h"

namespace limen::worlds {

namespace {

constexpr double kHillX = 78.0, kHillY = 396.0; // metres of the area

using Places = std::vector<std::pair<std::string, Eye>>;

Places villagePlaces(const VillageMap& map) {
    const auto home = [&](const Vec3& local) { return globalOf(map.cottage, local); };
    const auto next = [&](const Vec3& local) { return globalOf(map.neighbour, local); };
    const auto atHome = [&](const Vec3& eye, const Vec3& target, CottageCell c) {
        return eyeTowards(home(eye), home(target), map.cottageCells.at(static_cast<std::size_t>(c)));
    };
    const Vec3 between = 0.5 * (home({0.0, 0.0, 1.6}) + next({0.0, 0.0, 1.6}));
    return {
        {"hill", groundEye(kHillX, kHillY, between)},
        {"lane", groundEye(240.0, 289.0, between + Vec3(0.0, 2.5, 1.2))},
        {"cottage.front", groundEye(279.6, 285.6, home({0.0, 0.0, 2.2}))},
        {"cottage.room", atHome({-4.9, 0.95, 1.7}, {2.6, 3.2, 1.0}, CottageCell::Front)},
        {"cottage.rear", atHome({0.9, 5.35, 1.7}, {-0.35, 9.7, 1.3}, CottageCell::Rear)},
        {"cottage.stairs", atHome({-1.25, 8.1, -0.47}, {0.1, 0.3, 1.65}, CottageCell::Stairwell)},
        {"cottage.cellar", atHome({0.1, 8.95, -0.9}, {3.4, 4.4, -1.75}, CottageCell::Cellar)},
        {"cottage.shelf", atHome({4.0, 5.4, -0.9}, {-0.05, 8.34, -1.34}, CottageCell::Cellar)},
        {"neighbour.front", groundEye(278.0, 288.5, next({0.0, 0.0, 2.0}))},
        {"neighbour.room", eyeTowards(next({-0.9, 3.9, 1.7}), next({1.3, 0.3, 1.45}),
                                      map.neighbourCells.at(static_cast<std::size_t>(NeighbourCell::Room)))}};
}

/// Down the lane to the cottage's door; the eye looks two vertices ahead.
void toTheCottage(TourPath& path, const VillageMap& map) {
    const Vec3 door = globalOf(map.cottage, {0.0, 0.0, 1.6});
    path.look(door, 2.0);
    const VertexPath lane = lanePath();
    for (std::size_t i = 4; i + 2 < lane.size() && lane[i].first <= 10; ++i) {
        const int vx = lane[i].first;
        const Vec3 target = vx >= 6 ? door : overVertex(lane[i + 2], 1.2);
        path.ground(overVertex(lane[i], 0.0), vx >= 9 ? 8.0 : 11.0, target);
    }
    path.ground(globalOf(map.cottage, {-4.0, -9.5, 0.0}), 5.0, globalOf(map.neighbour, {0.0, 0.0, 1.5}));
    path.look(door, 2.0);
    path.ground(globalOf(map.cottage, {0.0, -2.2, 0.0}), 3.0, globalOf(map.cottage, {0.0, 9.7, 1.4}));
}

void throughTheCottage(TourPath& path, const VillageMap& map) {
    const auto at = [&](double x, double y, double z) { return globalOf(map.cottage, {x, y, z}); };
    // Up the steps, through the front room to the rear window.
    path.straight(at(0.0, -0.3, 1.7), 1.8, at(0.0, 9.7, 1.5));
    path.straight(at(0.0, 2.3, 1.7), 1.8, at(0.0, 9.7, 1.5));
    path.look(at(5.0, 2.6, 1.0), 1.5);
    path.look(at(-4.5, 3.0, 1.0), 2.0);
    path.look(at(0.0, 9.7, 1.5), 1.2);
    path.straight(at(0.0, 5.6, 1.7), 1.8, at(0.0, 9.7, 1.4));
    path.straight(at(0.1, 8.9, 1.7), 1.6, at(0.0, 20.0, 2.6));
    path.look(at(1.6, 20.0, 2.6), 1.5);
    path.look(at(4.6, 7.3, 1.0), 1.2);
    path.look(at(0.0, 0.0, 1.4), 1.5); // back through the house, out of the front door
    path.straight(at(0.0, 5.45, 1.7), 1.8, at(-4.0, 6.0, 1.0));
    path.straight(at(kStairsX, 5.4, 1.7), 1.4, at(kStairsX, 9.0, -0.6));
    // Down the stairs, a turn, through the low door, around the cellar.
    path.straight(at(kStairsX, kStairsTopY, 1.7), 1.2, at(kStairsX, 9.4, -1.0));
    path.straight(at(kStairsX, kStairsTopY + kStairsRun, 1.7 - kStairsDrop), 1.3, at(kStairsX, 9.5, -1.1));
    path.straight(at(kStairsX, 9.0, -0.9), 1.0, at(2.0, 9.0, -1.2));
    path.straight(at(0.3, 9.0, -0.9), 1.3, at(4.0, 5.0, -1.7));
    path.straight(at(2.6, 7.4, -0.9), 1.3, at(3.4, 3.6, -1.8));
    path.look(at(0.0, 3.8, -1.9), 1.5);
    path.look(at(-1.0, 9.0, -1.3), 1.2);
    path.straight(at(0.3, 9.0, -0.9), 1.5, at(-1.6, 9.0, -1.0));
    path.straight(at(kStairsX, 9.0, -0.9), 1.3, at(-0.1, 0.3, 1.9));
    path.look(at(-0.1, 0.3, 1.9), 1.5); // up the stairs, through both doors: the sky
    path.straight(at(kStairsX, kStairsTopY + kStairsRun, 1.7 - kStairsDrop), 1.0, at(kStairsX, 4.9, 1.4));
    path.straight(at(kStairsX, kStairsTopY, 1.7), 1.3, at(-0.3, 4.9, 1.5));
    path.straight(at(kStairsX, 5.4, 1.7), 1.2, at(0.0, 4.9, 1.5));
    path.straight(at(0.0, 5.3, 1.7), 1.4, at(0.0, 0.0, 1.5));
    path.look(at(0.0, 0.0, 1.5), 1.0);
}

nlohmann::ordered_json buildTour(const VillageMap& map, const DungeonMap& dungeons) {
    TourPath path;
    toTheCottage(path, map);
    throughTheCottage(path, map);
    for (const std::vector<TourLeg>& part : {eastTour(map), dungeonTour(dungeons)})
        path.legs.insert(path.legs.end(), part.begin(), part.end());
    return walkTour(groundEye(kHillX, kHillY, globalOf(map.cottage, {0.0, 0.0, 1.6})), path.legs);
}

} // namespace

Vec3 globalOf(const Placement& building, const Vec3& local) {
    return toGlobal(toArea(kVillage, place(building, local)));
}

nlohmann::ordered_json buildWorldFile(const VillageMap& map, const DungeonMap& dungeons) {
    nlohmann::ordered_json json;
    json["format"] = "limen world";
    json["version"] = 1;
    for (const Places& places : {villagePlaces(map), eastPlaces(map), dungeonPlaces(dungeons)})
        for (const auto& [name, eye] : places)
            json["places"][name] = toJson(eye);
    json["start"] = "cottage.front"; // outside, before a house with an open door
    json["tour"] = buildTour(map, dungeons);
    json["doors"] = map.doors;
    json["routes"] = map.routes;
    json["villagers"] = map.villagers;
    json["player"] = map.player;
    json["emitters"] = buildEmitters(map, dungeons);
    json["weather"] = "clear";
    return json;
}

} // namespace limen::worlds
