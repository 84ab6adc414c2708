#include "worlds/builtin/places/EastPlaces.h"

#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/buildings/MeetingHall.h"
#include "worlds/builtin/land/TerrainShape.h"

namespace limen::worlds {

namespace {

/// Collects legs of the tour in the coordinates of one building.
class Path {
public:
    explicit Path(const Placement& building) : building_(building) {}

    void at(const Placement& building) { building_ = building; }
    void ground(double x, double y, double speed, const Vec3& target) {
        path_.ground(point({x, y, 0.0}), speed, point(target));
    }
    /// Adds a leg to a point at eye height above `floor` that ends with a look at `target`.
    void walk(double x, double y, double floor, double speed, const Vec3& target) {
        path_.straight(point({x, y, floor + kEyeHeight}), speed, point(target));
    }
    void look(const Vec3& target, double seconds) { path_.look(point(target), seconds); }
    /// Adds a leg along the ground to a vertex of the lane.
    void lane(std::pair<int, int> vertex, double speed, const Vec3& targetGlobal) {
        path_.ground(overVertex(vertex, 0.0), speed, targetGlobal);
    }
    [[nodiscard]] const std::vector<TourLeg>& legs() const { return path_.legs; }

private:
    [[nodiscard]] Vec3 point(const Vec3& local) const { return globalOf(building_, local); }

    Placement building_;
    TourPath path_;
};

void toTheInn(Path& path, const VillageMap& map) {
    path.at(map.cottage);
    path.walk(0.0, 0.2, 0.0, 2.2, {0.0, -9.0, 1.5});
    path.ground(0.0, -2.4, 2.5, {6.0, -8.0, 1.2});
    path.ground(3.0, -8.0, 3.5, {20.0, -6.0, 3.0});
    path.at(map.inn);
    path.ground(-6.0, -6.0, 5.0, {0.0, 0.0, 2.5});
    path.ground(0.0, -3.4, 3.0, {0.0, 0.0, 1.8});
    path.walk(0.0, -0.2, 0.0, 1.8, {-1.0, 6.0, 1.4});
    path.walk(0.2, 2.1, 0.0, 1.8, {-4.0, 4.0, 1.2});
    path.look({-7.6, 3.3, 0.9}, 1.5);
    path.look({-0.8, 4.4, 4.4}, 1.5); // up through the shaft
    path.look({4.0, 2.1, 1.2}, 1.5);
}

/// From the hall through parlour and passage up the stairs to the balcony.
void upToTheBalcony(Path& path) {
    using namespace inn;
    path.walk(2.3, 2.1, 0.0, 1.8, {4.0, 2.6, 1.2});
    path.walk(2.3, 4.5, 0.0, 1.8, {2.3, 8.0, 1.3});
    path.walk(2.3, 5.75, 0.0, 1.8, {4.0, 5.8, 1.3});
    path.walk(kUpX, 5.75, 0.0, 1.6, {kUpX, 9.5, 2.6});
    path.walk(kUpX, kStairsFoot, 0.0, 1.4, {kUpX, 10.6, 4.4});
    path.walk(kUpX, kStairsHead, kUpper, 1.6, {kUpX, 10.7, kUpper + 1.4});
    path.walk(kUpX, 10.25, kUpper, 1.4, {0.0, 10.0, kUpper + 1.3});
    path.walk(1.9, 10.25, kUpper, 1.8, {1.7, 6.0, kUpper + 1.2});
    path.walk(1.9, 5.0, kUpper, 2.0, {-0.7, 4.0, 1.0});
    path.look({-1.2, 4.6, 0.9}, 1.5); // down into the hall
    path.walk(0.9, 1.6, kUpper, 1.8, {0.0, -1.0, kUpper + 1.3});
    path.walk(0.0, 1.2, kUpper, 1.6, {0.0, -4.0, kUpper + 0.9});
    path.walk(0.0, -0.9, kUpper, 1.6, {-8.0, -12.0, 1.0});
    path.look({-28.0, -4.0, 2.0}, 2.0);
    path.look({0.0, -16.0, 2.0}, 2.0); // the meeting hall across the lane
    path.look({0.0, 4.0, kUpper + 1.2}, 2.0);
}

/// Back down, through the store room to basement and vault.
void downToTheVault(Path& path) {
    using namespace inn;
    path.walk(0.0, 1.2, kUpper, 2.0, {1.6, 4.0, kUpper + 1.2});
    path.walk(1.9, 3.2, kUpper, 2.0, {1.9, 9.0, kUpper + 1.2});
    path.walk(1.9, 10.25, kUpper, 2.4, {4.0, 10.25, kUpper + 1.2});
    path.walk(kUpX, 10.25, kUpper, 1.8, {kUpX, 7.0, 2.2});
    path.walk(kUpX, kStairsHead, kUpper, 1.6, {kUpX, 6.0, 1.6});
    path.walk(kUpX, kStairsFoot, 0.0, 1.8, {kUpX, 5.3, 1.3});
    path.walk(kUpX, 5.75, 0.0, 1.6, {1.6, 5.75, 1.3});
    path.walk(2.3, 5.75, 0.0, 1.8, {2.3, 3.0, 1.3});
    path.walk(2.3, 4.2, 0.0, 1.8, {5.8, 4.4, 1.2});
    path.walk(5.85, 4.2, 0.0, 2.0, {5.85, 8.0, 0.8});
    path.walk(5.85, 5.7, 0.0, 1.8, {kDownX, 9.0, -0.8});
    path.walk(kDownX, kDownHead, 0.0, 1.4, {kDownX, 9.8, -1.4});
    path.walk(kDownX, kDownHead + kDownRun, kBasement, 1.6, {kDownX, 10.0, -1.4});
    path.walk(kDownX, 9.5, kBasement, 1.4, {3.0, 9.4, -1.2});
    path.walk(4.0, 9.3, kBasement, 1.6, {0.0, 7.0, -1.4});
    path.walk(0.6, 7.6, kBasement, 1.8, {-4.0, 7.2, -1.3});
    path.walk(-2.6, 7.2, kBasement, 1.8, {-7.0, 7.2, -1.4});
    path.look({4.0, 7.4, -1.6}, 2.0); // back through the wide opening
}

void outToTheMeetingHall(Path& path, const VillageMap& map) {
    using namespace inn;
    path.walk(0.6, 7.6, kBasement, 2.4, {4.0, 9.3, -1.3});
    path.walk(4.0, 9.3, kBasement, 2.4, {5.4, 9.5, -1.2});
    path.walk(kDownX, 9.5, kBasement, 2.0, {kDownX, 6.0, 0.8});
    path.walk(kDownX, kDownHead + kDownRun, kBasement, 1.6, {kDownX, 6.0, 1.4});
    path.walk(kDownX, kDownHead, 0.0, 1.8, {5.85, 4.0, 1.4});
    path.walk(5.85, 5.7, 0.0, 2.0, {5.85, 3.0, 1.4});
    path.walk(5.85, 4.2, 0.0, 2.0, {2.0, 2.1, 1.4});
    path.walk(2.3, 2.1, 0.0, 2.4, {0.0, 2.0, 1.4});
    path.walk(0.2, 2.0, 0.0, 2.0, {0.0, -3.0, 1.4});
    path.walk(0.0, -0.2, 0.0, 2.0, {0.0, -14.0, 2.0});
    path.ground(0.0, -2.6, 2.5, {0.0, -14.0, 2.4});
    path.at(map.hall);
    const double middle = hall::kMiddle;
    path.ground(-8.9, middle, 4.0, {6.0, middle, 2.4});
    path.walk(-6.4, middle, 0.0, 1.8, {6.0, middle, 2.6});
    path.walk(-3.6, middle, 0.0, 1.8, {6.5, middle, 3.4});
    path.look({1.9, 0.6, 2.6}, 2.0);
    path.look({6.5, middle, 2.4}, 1.5);
    path.walk(4.8, middle, 0.0, 2.0, {10.0, middle, 2.0});
    path.walk(6.8, middle, 0.0, 1.6, {10.0, middle, 1.8});
    path.look({-6.5, middle, 1.7}, 3.0); // back through arch and doorway: the inn
}

/// Out of the meeting hall and west between the cottages, nearly to the fork of lane and tower track.
void backToTheLane(Path& path) {
    const double middle = hall::kMiddle;
    const std::pair<int, int> fork = towerTrack().front();
    path.walk(4.8, middle, 0.0, 2.4, {-8.0, middle, 1.7});
    path.walk(-3.6, middle, 0.0, 3.0, {-12.0, middle, 1.7});
    path.walk(-6.4, middle, 0.0, 2.0, {-14.0, middle, 1.7});
    path.ground(-8.9, middle, 2.5, {-14.0, middle - 10.0, 1.7});
    path.lane({12, 12}, 4.5, overVertex(fork, 2.5));
    path.lane({10, 12}, 9.0, overVertex(towerTrack().at(4), 2.5));
}

} // namespace

std::vector<std::pair<std::string, Eye>> eastPlaces(const VillageMap& map) {
    const auto inside = [&](InnCell cell, const Vec3& eye, const Vec3& target) {
        return eyeTowards(globalOf(map.inn, eye), globalOf(map.inn, target),
                          map.innCells.at(static_cast<std::size_t>(cell)));
    };
    const Vec3 balcony{1.4, -0.9, inn::kBalcony + kEyeHeight};
    return {
        {"inn.hall", inside(InnCell::Hall, {1.2, 2.5, kEyeHeight}, {-4.6, 4.9, 1.25})},
        {"inn.balcony", eyeTowards(globalOf(map.inn, balcony), globalOf(map.inn, {-16.0, -10.0, 1.4}), 0)},
        {"inn.basement",
         inside(InnCell::Basement, {4.2, 9.1, inn::kBasement + kEyeHeight}, {-1.5, 6.6, -1.5})},
        {"meetinghall", eyeTowards(globalOf(map.hall, {-4.25, hall::kMiddle - 0.5, kEyeHeight}),
                                   globalOf(map.hall, {6.3, hall::kMiddle + 0.3, 2.3}),
                                   map.hallCells.at(static_cast<std::size_t>(HallCell::Nave)))}};
}

std::vector<TourLeg> eastTour(const VillageMap& map) {
    Path path(map.cottage);
    toTheInn(path, map);
    upToTheBalcony(path);
    downToTheVault(path);
    outToTheMeetingHall(path, map);
    backToTheLane(path);
    return path.legs();
}

} // namespace limen::worlds
