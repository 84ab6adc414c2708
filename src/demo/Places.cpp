#include "demo/Places.h"

#include "demo/Cottages.h"
#include "demo/DungeonPlaces.h"
#include "demo/TerrainShape.h"

#include <fmt/format.h>

namespace limen::demo {

namespace {

constexpr double kEyeHeight = 1.7;
constexpr double kPi = 3.14159265358979323846;

Vec3 villageToArea(const Vec3& p) {
    return p + Vec3(192.0, 192.0, 0.0);
}

/// An eye on the ground at a point of the area.
Eye outdoorEye(double x, double y) {
    Eye eye;
    eye.position = toGlobal({x, y, groundHeight(x, y) + kEyeHeight});
    return eye;
}

/// A point of a building on the map.
Vec3 globalOf(const Placement& building, const Vec3& local) {
    return toGlobal(villageToArea(place(building, local)));
}

Eye indoorEye(const Placement& building, const Vec3& local, const Vec3& target, dat::RecordId cell) {
    Eye eye;
    eye.position = globalOf(building, local);
    eye.cell = cell;
    lookAt(eye, globalOf(building, target));
    return eye;
}

Eye looking(Eye eye, const Vec3& target) {
    lookAt(eye, target);
    return eye;
}

double rounded(double v, double step) {
    return std::round(v / step) * step;
}

nlohmann::ordered_json toJson(const Eye& eye) {
    nlohmann::ordered_json json;
    json["x"] = rounded(eye.position.x, 1.0 / 1024.0);
    json["y"] = rounded(eye.position.y, 1.0 / 1024.0);
    json["z"] = rounded(eye.position.z, 1.0 / 1024.0);
    json["yaw"] = rounded(eye.yaw, 1.0 / 64.0);
    json["pitch"] = rounded(eye.pitch, 1.0 / 64.0);
    if (eye.cell != 0) {
        json["cell"] = fmt::format("0x{:08X}", eye.cell);
    }
    return json;
}

/// Walks the tour: adds samples along straight legs, the eye turning evenly and following the ground.
class Walk {
public:
    /// Outdoors: along the ground to a point of the area, looking at `target` on arrival.
    void alongGround(double x, double y, double speed, const Vec3& target) {
        leg(
            speed, 1.0,
            [&](double t, const Eye& from) {
                const Vec3 start = from.position - toGlobal(Vec3(0.0));
                return outdoorEye(start.x + (x - start.x) * t, start.y + (y - start.y) * t).position;
            },
            looking(outdoorEye(x, y), target));
    }
    /// Straight through the air: indoors, over steps.
    void straight(const Vec3& to, double speed, const Vec3& target, double stride = 0.25) {
        Eye end;
        end.position = to;
        lookAt(end, target);
        leg(
            speed, stride,
            [&](double t, const Eye& from) { return from.position + (to - from.position) * t; }, end);
    }
    /// Stands and turns.
    void look(const Vec3& target, double seconds) {
        Eye end = eyes_.back();
        lookAt(end, target);
        const Eye from = eyes_.back();
        const int steps = std::max(2, static_cast<int>(seconds * 4.0));
        for (int k = 1; k <= steps; ++k) {
            push(from.position, from, end, static_cast<double>(k) / steps, seconds / steps);
        }
    }
    void start(const Eye& eye) {
        eyes_.push_back(eye);
        times_.push_back(0.0);
    }
    [[nodiscard]] nlohmann::ordered_json toJsonList() const {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < eyes_.size(); ++i) {
            nlohmann::ordered_json item = toJson(eyes_[i]);
            item["t"] = rounded(times_[i], 1.0 / 64.0);
            list.push_back(std::move(item));
        }
        return list;
    }

private:
    template <class Position>
    void leg(double speed, double stride, Position positionAt, const Eye& end) {
        const Eye from = eyes_.back();
        const double length = glm::length(end.position - from.position);
        const int steps = std::max(1, static_cast<int>(std::ceil(length / stride)));
        for (int k = 1; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            push(positionAt(t, from), from, end, t, length / speed / steps);
        }
    }
    void push(const Vec3& position, const Eye& from, const Eye& to, double t, double seconds) {
        Eye eye;
        eye.position = position;
        const double turn = std::remainder(to.yaw - from.yaw, 360.0);
        const double eased = t * t * (3.0 - 2.0 * t);
        eye.yaw = std::fmod(from.yaw + turn * eased + 720.0, 360.0);
        eye.pitch = from.pitch + (to.pitch - from.pitch) * eased;
        eyes_.push_back(eye);
        times_.push_back(times_.back() + seconds);
    }

    std::vector<Eye> eyes_;
    std::vector<double> times_;
};

constexpr double kHillX = 78.0, kHillY = 396.0; // area

nlohmann::ordered_json buildPlaces(const VillageMap& map) {
    const auto cell = [&](CottageCell c) { return map.cottageCells[static_cast<std::size_t>(c)]; };
    const auto theirs = [&](NeighbourCell c) { return map.neighbourCells[static_cast<std::size_t>(c)]; };
    const Placement& home = map.cottage;
    const Placement& next = map.neighbour;
    const Vec3 homeDoor = globalOf(home, {0.0, 0.0, 1.6});
    const Vec3 nextDoor = globalOf(next, {0.0, 0.0, 1.6});
    const Vec3 between = 0.5 * (homeDoor + nextDoor);
    nlohmann::ordered_json places;
    places["hill"] = toJson(looking(outdoorEye(kHillX, kHillY), between));
    places["lane"] = toJson(looking(outdoorEye(240.0, 289.0), between + Vec3(0.0, 2.5, 1.2)));
    places["cottage.front"] = toJson(looking(outdoorEye(279.6, 285.6), globalOf(home, {-0.7, 0.0, 2.5})));
    places["cottage.room"] =
        toJson(indoorEye(home, {-4.9, 0.95, 1.7}, {2.6, 3.2, 1.0}, cell(CottageCell::Front)));
    places["cottage.rear"] =
        toJson(indoorEye(home, {0.9, 5.35, 1.7}, {-0.35, 9.7, 1.3}, cell(CottageCell::Rear)));
    places["cottage.stairs"] =
        toJson(indoorEye(home, {-1.25, 8.1, -0.47}, {0.1, 0.3, 1.65}, cell(CottageCell::Stairwell)));
    places["cottage.cellar"] =
        toJson(indoorEye(home, {0.1, 8.95, -0.9}, {3.4, 4.4, -1.75}, cell(CottageCell::Cellar)));
    places["neighbour.front"] = toJson(looking(outdoorEye(278.0, 288.5), globalOf(next, {0.0, 0.0, 2.0})));
    places["neighbour.room"] =
        toJson(indoorEye(next, {-0.9, 3.9, 1.7}, {1.3, 0.3, 1.45}, theirs(NeighbourCell::Room)));
    return places;
}

/// Walks what another part of the world adds to the tour.
void follow(Walk& walk, const std::vector<TourLeg>& legs) {
    for (const TourLeg& leg : legs) {
        switch (leg.kind) {
        case TourLeg::Kind::Ground:
            walk.alongGround(leg.to.x, leg.to.y, leg.speed, leg.target);
            break;
        case TourLeg::Kind::Straight:
            walk.straight(toGlobal(leg.to), leg.speed, leg.target);
            break;
        case TourLeg::Kind::Flight:
            walk.straight(toGlobal(leg.to), leg.speed, leg.target, 1.25);
            break;
        case TourLeg::Kind::Look:
            walk.look(leg.target, leg.speed);
            break;
        }
    }
}

nlohmann::ordered_json buildTour(const VillageMap& map, const DungeonMap& dungeons) {
    const auto at = [&](double x, double y, double z) { return globalOf(map.cottage, {x, y, z}); };
    const auto ahead = [](int vx, int vy) {
        const double x = vx * kLandcell;
        const double y = vy * kLandcell;
        return toGlobal({x, y, groundHeight(x, y) + 1.2});
    };
    const Vec3 door = at(0.0, 0.0, 1.6);
    Walk walk;
    walk.start(looking(outdoorEye(kHillX, kHillY), door));
    walk.look(door, 2.0);
    // Down the lane, looking two vertices ahead.
    const std::vector<std::pair<int, int>> lane = lanePath();
    for (std::size_t i = 4; i + 2 < lane.size() && lane[i].first <= 10; ++i) {
        const auto [vx, vy] = lane[i];
        const Vec3 target = vx >= 6 ? door : ahead(lane[i + 2].first, lane[i + 2].second);
        walk.alongGround(vx * kLandcell, vy * kLandcell, vx >= 9 ? 8.0 : 11.0, target);
    }
    const Vec3 areaDoor = villageToArea(place(map.cottage, {0.0, 0.0, 0.0}));
    walk.alongGround(areaDoor.x - 4.0, areaDoor.y - 9.5, 5.0, globalOf(map.neighbour, {0.0, 0.0, 1.5}));
    walk.look(door, 2.0);
    walk.alongGround(areaDoor.x, areaDoor.y - 2.2, 3.0, at(0.0, 9.7, 1.4));
    // Up the steps, through the front room to the rear window.
    walk.straight(at(0.0, -0.3, 1.7), 1.8, at(0.0, 9.7, 1.5));
    walk.straight(at(0.0, 2.3, 1.7), 1.8, at(0.0, 9.7, 1.5));
    walk.look(at(5.0, 2.6, 1.0), 1.5);
    walk.look(at(-4.5, 3.0, 1.0), 2.0);
    walk.look(at(0.0, 9.7, 1.5), 1.2);
    walk.straight(at(0.0, 5.6, 1.7), 1.8, at(0.0, 9.7, 1.4));
    walk.straight(at(0.1, 8.9, 1.7), 1.6, at(0.0, 20.0, 2.6));
    walk.look(at(1.6, 20.0, 2.6), 1.5);
    walk.look(at(4.6, 7.3, 1.0), 1.2);
    walk.look(at(0.0, 0.0, 1.4), 1.5); // back through the house, out of the front door
    walk.straight(at(0.0, 5.45, 1.7), 1.8, at(-4.0, 6.0, 1.0));
    walk.straight(at(kStairsX, 5.4, 1.7), 1.4, at(kStairsX, 9.0, -0.6));
    // Down the stairs, turn, through the low door, around the cellar.
    walk.straight(at(kStairsX, kStairsTopY, 1.7), 1.2, at(kStairsX, 9.4, -1.0));
    walk.straight(at(kStairsX, kStairsTopY + kStairsRun, 1.7 - kStairsDrop), 1.3, at(kStairsX, 9.5, -1.1));
    walk.straight(at(kStairsX, 9.0, -0.9), 1.0, at(2.0, 9.0, -1.2));
    walk.straight(at(0.3, 9.0, -0.9), 1.3, at(4.0, 5.0, -1.7));
    walk.straight(at(2.6, 7.4, -0.9), 1.3, at(3.4, 3.6, -1.8));
    walk.look(at(0.0, 3.8, -1.9), 1.5);
    walk.look(at(-1.0, 9.0, -1.3), 1.2);
    walk.straight(at(0.3, 9.0, -0.9), 1.5, at(-1.6, 9.0, -1.0));
    walk.straight(at(kStairsX, 9.0, -0.9), 1.3, at(-0.1, 0.3, 1.9));
    walk.look(at(-0.1, 0.3, 1.9), 1.5); // up the stairs, through both doors: the sky
    walk.straight(at(kStairsX, kStairsTopY + kStairsRun, 1.7 - kStairsDrop), 1.0, at(kStairsX, 4.9, 1.4));
    walk.straight(at(kStairsX, kStairsTopY, 1.7), 1.3, at(-0.3, 4.9, 1.5));
    walk.straight(at(kStairsX, 5.4, 1.7), 1.2, at(0.0, 4.9, 1.5));
    walk.straight(at(0.0, 5.3, 1.7), 1.4, at(0.0, 0.0, 1.5));
    walk.look(at(0.0, 0.0, 1.5), 1.0);
    // Out by the front door and along the lane, to where the track leaves it.
    walk.straight(at(0.0, -0.3, 1.7), 2.5, at(0.0, -6.0, 1.5));
    walk.alongGround(areaDoor.x, areaDoor.y - 6.0, 3.0, ahead(10, 12));
    follow(walk, dungeonTour(dungeons));
    return walk.toJsonList();
}

} // namespace

void lookAt(Eye& eye, const Vec3& target) {
    const Vec3 d = target - eye.position;
    eye.yaw = std::fmod(std::atan2(d.x, d.y) * 180.0 / kPi + 360.0, 360.0);
    eye.pitch = std::atan2(d.z, std::hypot(d.x, d.y)) * 180.0 / kPi;
}

nlohmann::ordered_json buildWorldFile(const VillageMap& map, const DungeonMap& dungeons) {
    nlohmann::ordered_json json;
    json["format"] = "limen world";
    json["version"] = 1;
    json["places"] = buildPlaces(map);
    for (const auto& [name, eye] : dungeonPlaces(dungeons)) {
        json["places"][name] = toJson(eye);
    }
    json["tour"] = buildTour(map, dungeons);
    json["doors"] = nlohmann::ordered_json::array();
    json["villagers"] = nlohmann::ordered_json::array();
    json["routes"] = nlohmann::ordered_json::array();
    json["emitters"] = dungeonEmitters(dungeons);
    return json;
}

} // namespace limen::demo
