#include "worlds/builtin/dungeon/DungeonPlaces.h"

#include "worlds/builtin/dungeon/Cave.h"
#include "worlds/builtin/dungeon/Tower.h"
#include "worlds/builtin/land/TerrainShape.h"

namespace limen::worlds {

namespace {

/// Converts points of tower and cave to global metres.
Vec3 inTower(const DungeonMap& map, const Vec3& local) {
    return toGlobal(toArea(kTowerBlock, place(map.tower, local)));
}
Vec3 inCave(const DungeonMap& map, const Vec3& local) {
    return toGlobal(toArea(kCaveBlock, place(map.cave, local)));
}

/// A viewpoint on the ground; global metres.
Eye eyeBefore(const Vec3& at, const Vec3& target) {
    const Vec3 area = at - toGlobal(Vec3(0.0));
    return groundEye(area.x, area.y, target);
}

/// The eye on the winding stair when the feet are at height z.
Vec3 onStair(double z) {
    const double a = stairAngle(z);
    return {kStairRadius * std::cos(a), kStairRadius * std::sin(a), z + kEyeHeight};
}

class Tour {
public:
    explicit Tour(const DungeonMap& map) : map_(map) {}

    /// Up the track, in through the door, up the stair to the roof, a look around.
    void toTheRoof() {
        const Vec3 door = inTower(map_, {0.0, -kTowerOuter, 2.0});
        for (const auto& vertex : towerTrack())
            path.ground(overVertex(vertex, 0.0), 13.0, inTower(map_, {0.0, 0.0, 9.0}));
        path.ground(inTower(map_, {0.0, -7.0, 0.0}), 8.0, door);
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
    /// Over the parapet, down to the cave and through the hub to the pit.
    void toThePit() {
        const Vec3 mouth{0.0, 0.0, 1.6};
        path.flight(inTower(map_, {14.0, -22.0, 19.0}), 12.0, inCave(map_, mouth));
        path.flight(inCave(map_, {-14.0, -30.0, 12.0}), 24.0, inCave(map_, mouth));
        path.flight(inCave(map_, {0.0, -9.0, kEyeHeight}), 10.0, inCave(map_, mouth));
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
    TourPath path;

private:
    void tower(const Vec3& to, double speed, const Vec3& target) {
        path.straight(inTower(map_, to), speed, inTower(map_, target));
    }
    void look(const Vec3& target, double seconds) { path.look(inTower(map_, target), seconds); }
    void cave(const Vec3& to, double speed, const Vec3& target) {
        path.flight(inCave(map_, to), speed, inCave(map_, target));
    }
    void lookInCave(const Vec3& target, double seconds) { path.look(inCave(map_, target), seconds); }

    const DungeonMap& map_;
};

} // namespace

std::vector<std::pair<std::string, Eye>> dungeonPlaces(const DungeonMap& map) {
    const double floor = kDungeonFloor + kEyeHeight;
    const auto cell = [&](std::size_t k) { return map.caveCells.at(k); };
    const Vec3 sealed = toGlobal(toArea(kSealedBlock, map.sealed.origin));
    return {{"tower.foot", eyeBefore(inTower(map, {-7.0, -22.0, 0.0}), inTower(map, {0.0, 0.0, 7.5}))},
            {"tower.top", eyeTowards(inTower(map, {0.1, -3.9, kTowerRoof + kEyeHeight}),
                                     inTower(map, {-14.0, -190.0, -16.0}), 0)},
            {"cave", eyeBefore(inCave(map, {-5.0, -15.0, 0.0}), inCave(map, {0.0, 0.0, 2.4}))},
            {"dungeon.hub", eyeTowards(inCave(map, {-0.4, kHubY - 7.4, floor}),
                                       inCave(map, {0.9, kHubY + 8.0, floor + 0.8}), cell(map.parts.hub))},
            {"dungeon.pit", eyeTowards(inCave(map, {kPitX + 5.4, kPitY + 2.25, floor}),
                                       inCave(map, {kPitX - 5.0, kPitY - 3.0, kDungeonFloor - 9.0}),
                                       cell(map.parts.gallery))},
            {"dungeon.sealed", eyeTowards(sealed + Vec3(-4.5, -2.0, kEyeHeight), sealed + Vec3(6.0, 0.8, 1.9),
                                          map.sealedCells.at(0))}};
}

std::vector<TourLeg> dungeonTour(const DungeonMap& map) {
    Tour tour(map);
    tour.toTheRoof();
    tour.toThePit();
    return std::move(tour.path.legs);
}

std::vector<Fire> brazierFires(const DungeonMap& map) {
    const auto outside = [](double x, double y) {
        return toGlobal(toArea(kCaveBlock, {x, y, caveLevel() + 1.0}));
    };
    return {{"hub.brazier", inCave(map, {0.0, kHubY, kDungeonFloor + 1.0}), map.caveCells.at(map.parts.hub)},
            {"chamber.brazier", inCave(map, {kChamberX + 3.6, kChamberY + 1.5, kChamberFloor + 1.0}),
             map.caveCells.at(map.chamber)},
            {"cave.brazier.west", outside(81.0, 20.5), 0},
            {"cave.brazier.east", outside(87.2, 20.4), 0}};
}

} // namespace limen::worlds
