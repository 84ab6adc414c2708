#include "demo/DungeonPlaces.h"

#include "demo/Cave.h"
#include "demo/TerrainShape.h"
#include "demo/Tower.h"

#include <fmt/format.h>

namespace limen::demo {

namespace {

constexpr double kEyeHeight = 1.7;

Vec3 inTower(const DungeonMap& map, const Vec3& local) {
    return toArea(kTowerBlock, place(map.tower, local));
}
Vec3 inCave(const DungeonMap& map, const Vec3& local) {
    return toArea(kCaveBlock, place(map.cave, local));
}

Eye eyeAt(const Vec3& area, const Vec3& target, dat::RecordId cell) {
    Eye eye;
    eye.position = toGlobal(area);
    eye.cell = cell;
    lookAt(eye, toGlobal(target));
    return eye;
}

/// A standing eye on the ground before something.
Eye groundEye(const Vec3& area, const Vec3& target) {
    return eyeAt({area.x, area.y, groundHeight(area.x, area.y) + kEyeHeight}, target, 0);
}

/// Where the eye is on the winding stair when the feet are at height z.
Vec3 onStair(double z) {
    const double a = stairAngle(z);
    return {kStairRadius * std::cos(a), kStairRadius * std::sin(a), z + kEyeHeight};
}

class Tour {
public:
    explicit Tour(const DungeonMap& map) : map_(map) {}
    using Kind = TourLeg::Kind;

    /// Up the track, in by the door, up the stair to the roof, a look around.
    void toTheRoof() {
        const Vec3 door = inTower(map_, {0.0, -kTowerOuter, 2.0});
        for (const auto& [vx, vy] : towerTrack()) {
            add(Kind::Ground, {vx * kLandcell, vy * kLandcell, 0.0}, 13.0, inTower(map_, {0.0, 0.0, 9.0}));
        }
        add(Kind::Ground, inTower(map_, {0.0, -7.0, 0.0}), 8.0, door);
        tower({0.0, -5.5, kEyeHeight}, 2.0, {0.0, 4.0, 1.6});
        tower({0.0, -3.0, kEyeHeight}, 2.0, {3.0, 2.0, 2.2});
        tower({2.6, -1.2, kEyeHeight}, 2.0, {0.0, 2.0, 2.5});
        constexpr int kLegs = 36;
        for (int k = 0; k <= kLegs; ++k) {
            const double z = kTowerRoof * k / kLegs;
            tower(onStair(z), 2.2, onStair(std::min(z + 1.4, kTowerRoof + 1.0)) * Vec3(2.2, 2.2, 1.0));
        }
        tower({2.9, 0.3, kTowerRoof + kEyeHeight}, 1.6, {40.0, -60.0, 6.0});
        tower({2.6, -3.2, kTowerRoof + kEyeHeight}, 1.8, {0.0, -90.0, -8.0});
        tower({0.0, -4.1, kTowerRoof + kEyeHeight}, 1.8, {-10.0, -170.0, -20.0});
        look({-90.0, -30.0, 0.0}, 2.5);
        look({90.0, -40.0, 0.0}, 2.5);
    }
    /// Over the parapet and down to the cave, in, and through the hub to the pit.
    void toThePit() {
        const Vec3 mouth{0.0, 0.0, 1.6};
        add(Kind::Flight, inTower(map_, {14.0, -22.0, 19.0}), 12.0, inCave(map_, mouth));
        add(Kind::Flight, inCave(map_, {-14.0, -30.0, 12.0}), 24.0, inCave(map_, mouth));
        add(Kind::Flight, inCave(map_, {0.0, -9.0, kEyeHeight}), 10.0, inCave(map_, mouth));
        const double floor = kDungeonFloor + kEyeHeight;
        cave({0.0, -1.0, kEyeHeight}, 4.0, {0.5, 6.0, 0.4});
        cave({0.5, 6.0, -1.0 + kEyeHeight}, 3.0, {-1.0, 14.0, -2.6});
        cave({-1.0, 14.0, kChamberFloor + kEyeHeight}, 3.0, {-1.0, 26.0, -3.0});
        cave({-1.0, 26.0, kChamberFloor + kEyeHeight}, 4.0, {0.0, 52.0, -14.6});
        cave({0.0, kEntranceY, floor}, 4.0, {0.0, kHubY, floor});
        cave({0.0, kHubY - 6.0, floor}, 4.0, {0.0, kHubY + 8.0, floor + 0.5});
        lookInCave({8.0, kHubY, floor}, 1.5);
        lookInCave({6.0, kHubY + 7.0, floor + 2.0}, 1.5);
        cave({-2.2, kHubY - 1.5, floor}, 3.0, {-8.0, kHubY, floor});
        cave({-6.5, kHubY, floor}, 3.0, {-40.0, kHubY, floor});
        cave({kPitX + 6.5, kHubY, floor}, 5.0, {kPitX, kHubY, floor - 1.0});
        cave({kPitX + 5.4, kHubY + 2.25, floor}, 2.0, {kPitX - 5.0, kHubY - 1.0, kDungeonFloor - 14.0});
        lookInCave({kPitX - 2.0, kHubY - 4.0, kDungeonFloor - 30.0}, 2.5);
    }
    std::vector<TourLeg> legs;

private:
    void add(Kind kind, const Vec3& area, double speed, const Vec3& target) {
        legs.push_back({kind, area, speed, toGlobal(target)});
    }
    void tower(const Vec3& to, double speed, const Vec3& target) {
        add(Kind::Straight, inTower(map_, to), speed, inTower(map_, target));
    }
    void look(const Vec3& target, double seconds) { add(Kind::Look, {}, seconds, inTower(map_, target)); }
    void cave(const Vec3& to, double speed, const Vec3& target) {
        add(Kind::Flight, inCave(map_, to), speed, inCave(map_, target));
    }
    void lookInCave(const Vec3& target, double seconds) {
        add(Kind::Look, {}, seconds, inCave(map_, target));
    }

    const DungeonMap& map_;
};

nlohmann::ordered_json sparks(const std::string& name, const Vec3& area, dat::RecordId cell) {
    const Vec3 at = toGlobal(area);
    nlohmann::ordered_json e;
    e["name"] = name;
    e["surface"] = fmt::format("0x{:08X}", surfaceId(Material::Flame));
    e["position"] = {at.x, at.y, at.z};
    e["cell"] = cell == 0 ? "outside" : fmt::format("0x{:08X}", cell);
    e["attachedTo"] = "";
    e["rate"] = 7;
    e["life"] = 1.25;
    e["velocity"] = {0.0, 0.0, 0.9};
    e["spread"] = 0.2;
    e["acceleration"] = {0.0, 0.0, 0.3};
    e["radius"] = 0.2;
    e["size"] = {0.22, 0.06};
    e["alpha"] = {0.8, 0.0};
    e["seed"] = 7;
    return e;
}

} // namespace

std::vector<std::pair<std::string, Eye>> dungeonPlaces(const DungeonMap& map) {
    const double floor = kDungeonFloor + kEyeHeight;
    const auto cell = [&](std::size_t k) { return map.caveCells.at(k); };
    const Vec3 sealed = toArea(kSealedBlock, map.sealed.origin);
    return {{"tower.foot", groundEye(inTower(map, {-7.0, -22.0, 0.0}), inTower(map, {0.0, 0.0, 7.5}))},
            {"tower.top", eyeAt(inTower(map, {0.1, -3.9, kTowerRoof + kEyeHeight}),
                                inTower(map, {-14.0, -190.0, -16.0}), 0)},
            {"cave", groundEye(inCave(map, {-5.0, -15.0, 0.0}), inCave(map, {0.0, 0.0, 2.4}))},
            {"dungeon.hub", eyeAt(inCave(map, {-0.4, kHubY - 7.4, floor}),
                                  inCave(map, {0.9, kHubY + 8.0, floor + 0.8}), cell(map.parts.hub))},
            {"dungeon.pit",
             eyeAt(inCave(map, {kPitX + 5.4, kPitY + 2.25, floor}),
                   inCave(map, {kPitX - 5.0, kPitY - 3.0, kDungeonFloor - 9.0}), cell(map.parts.gallery))},
            {"dungeon.sealed", eyeAt(sealed + Vec3(-4.5, -2.0, kEyeHeight), sealed + Vec3(6.0, 0.8, 1.9),
                                     map.sealedCells.at(0))}};
}

std::vector<TourLeg> dungeonTour(const DungeonMap& map) {
    Tour tour(map);
    tour.toTheRoof();
    tour.toThePit();
    return std::move(tour.legs);
}

nlohmann::ordered_json dungeonEmitters(const DungeonMap& map) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    list.push_back(sparks("hub.brazier", inCave(map, {0.0, kHubY, kDungeonFloor + 1.0}),
                          map.caveCells.at(map.parts.hub)));
    list.push_back(sparks("chamber.brazier",
                          inCave(map, {kChamberX + 3.6, kChamberY + 1.5, kChamberFloor + 1.0}),
                          map.caveCells.at(map.chamber)));
    for (const double x : {81.0, 87.2}) {
        const double y = x < 84.0 ? 20.5 : 20.4;
        const Vec3 foot = toArea(kCaveBlock, {x, y, caveLevel()});
        list.push_back(
            sparks(x < 84.0 ? "cave.brazier.west" : "cave.brazier.east", foot + Vec3(0.0, 0.0, 1.0), 0));
    }
    return list;
}

} // namespace limen::demo
