#include "geometry/Angles.h"
#include "worlds/Shell.h"
#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/dungeon/Tower.h"
#include "worlds/builtin/land/TerrainShape.h"

#include <gtest/gtest.h>

namespace limen::worlds::test {
namespace {

Vec3 eyeOf(const nlohmann::ordered_json& json) {
    return {json.at("x").get<double>(), json.at("y").get<double>(), json.at("z").get<double>()};
}

/// The cell at a global point, or null.
const dat::EnvCell* cellAt(const Vec3& global) {
    for (const dat::EnvCell& cell : world().envCells)
        if (contains(cell, inBlock(blockOf(cell.id), global)))
            return &cell;
    return nullptr;
}

double ground(const Vec3& global) {
    return groundHeight(global.x - kSouthWest.x * 192.0, global.y - kSouthWest.y * 192.0);
}

TEST(Places, areAllThereAndInTheCellTheyName) {
    const auto& places = world().worldFile.at("places");
    const std::map<std::string, double> floors{
        {"inn.balcony", siteLevel() + kFloorAboveGround + inn::kBalcony},
        {"tower.top", towerLevel() + kTowerSill + kTowerRoof}}; // outside, above the ground
    for (const char* name :
         {"hill", "lane", "cottage.front", "cottage.room", "cottage.rear", "cottage.stairs", "cottage.cellar",
          "neighbour.front", "neighbour.room", "inn.hall", "inn.balcony", "inn.basement", "meetinghall",
          "tower.foot", "tower.top", "cave", "dungeon.hub", "dungeon.pit", "dungeon.sealed"}) {
        ASSERT_TRUE(places.contains(name)) << name;
        const auto& place = places.at(name);
        const dat::EnvCell* cell = cellAt(eyeOf(place));
        ASSERT_EQ(cell != nullptr, place.contains("cell")) << name;
        if (cell != nullptr) {
            EXPECT_EQ(std::stoul(place.at("cell").get<std::string>(), nullptr, 16), cell->id) << name;
        } else {
            const auto raised = floors.find(name);
            const double feet = raised != floors.end() ? raised->second : ground(eyeOf(place));
            EXPECT_NEAR(eyeOf(place).z, feet + 1.7, 0.01) << name;
        }
    }
}

/// A point of a door leaf at its openness in the file; `along`: metres from the hinge.
Vec3 onLeaf(const nlohmann::ordered_json& door, const nlohmann::ordered_json& leaf, double along, double up) {
    const auto& hinge = leaf.at("position");
    const double turn =
        (leaf.at("yaw").get<double>() + leaf.at("swing").get<double>() * door.at("open").get<double>()) *
        kDegree;
    return {hinge[0].get<double>() + along * std::cos(turn), hinge[1].get<double>() - along * std::sin(turn),
            hinge[2].get<double>() + up};
}

/// The angle (degrees) between a place's heading and a point, seen from above.
double besideView(const nlohmann::ordered_json& place, const Vec3& point) {
    const Vec3 d = point - eyeOf(place);
    return std::abs(std::remainder(std::atan2(d.x, d.y) / kDegree - place.at("yaw").get<double>(), 360.0));
}

TEST(Places, haveNoOpenDoorJustBeforeTheEye) {
    constexpr double kHalfView = 35.0, kNear = 2.0,
                     kLeaf = 0.9; // degrees; metres; metres of a leaf that are sampled
    std::size_t leaves = 0;
    for (const auto& [name, place] : world().worldFile.at("places").items()) {
        for (const auto& door : world().worldFile.at("doors")) {
            if (!door.at("opaque").get<bool>() || door.at("open").get<double>() == 0.0)
                continue;
            for (const auto& leaf : door.at("leaves")) {
                ++leaves;
                for (int k = 0; k <= 8; ++k) {
                    const Vec3 p = onLeaf(door, leaf, kLeaf * k / 8, 1.2);
                    const bool near = glm::length(p - eyeOf(place)) < kNear;
                    EXPECT_FALSE(near && besideView(place, p) < kHalfView)
                        << name << ": " << door.at("name") << " at " << k;
                }
            }
        }
    }
    EXPECT_GT(leaves, 100u);
}

TEST(Tour, samplesAreCloseAndInTime) {
    const auto& tour = world().worldFile.at("tour");
    ASSERT_GT(tour.size(), 100u);
    double last = -1.0;
    for (std::size_t i = 0; i < tour.size(); ++i) {
        const double t = tour[i].at("t").get<double>();
        EXPECT_GT(t, last);
        last = t;
        if (i > 0)
            EXPECT_LT(glm::length(eyeOf(tour[i]) - eyeOf(tour[i - 1])), 1.6);
    }
    EXPECT_GT(last, 60.0);
    EXPECT_LT(last, 300.0);
}

/// The cells of the village that the tour enters, in order. After it leaves a house it enters the same cell
/// again, or the next house.
std::vector<std::uint32_t> expectedVillageVisits() {
    std::vector<std::uint32_t> out{0x100, 0x101, 0x102, 0x103, 0x104, 0x105,
                                   0x104, 0x103, 0x102, 0x101, 0x100};
    using C = InnCell;
    for (const C cell : {C::Hall,       C::ParlourDoor,  C::Parlour,        C::PassageDoor,
                         C::Passage,    C::StairsDoor,   C::Stairs,         C::LandingDoor,
                         C::Landing,    C::Landing,      C::LandingDoor,    C::Stairs,
                         C::StairsDoor, C::Passage,      C::PassageDoor,    C::Parlour,
                         C::StoreDoor,  C::Store,        C::BasementStairs, C::BasementDoor,
                         C::Basement,   C::VaultArch,    C::Vault,          C::VaultArch,
                         C::Basement,   C::BasementDoor, C::BasementStairs, C::Store,
                         C::StoreDoor,  C::Parlour,      C::ParlourDoor,    C::Hall})
        out.push_back(0x109 + static_cast<std::uint32_t>(cell));
    const std::uint32_t hall = 0x109 + static_cast<std::uint32_t>(C::Count);
    out.insert(out.end(), {hall, hall + 1, hall}); // nave and arch
    for (std::uint32_t& cell : out)
        cell |= dat::landBlockId(kVillage) & 0xFFFF0000u;
    return out;
}

std::vector<std::uint32_t> ofVillage(std::vector<std::uint32_t> cells) {
    cells.erase(
        std::remove_if(cells.begin(), cells.end(), [](std::uint32_t id) { return blockOf(id) != kVillage; }),
        cells.end());
    return cells;
}

TEST(Tour, goesThroughEveryPartOfTheHousesAndNeverThroughAWall) {
    const auto& tour = world().worldFile.at("tour");
    std::vector<std::uint32_t> visited;
    const dat::EnvCell* last = nullptr;
    for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
        for (int k = 0; k < 20; ++k) {
            const Vec3 p = eyeOf(tour[i]) + (eyeOf(tour[i + 1]) - eyeOf(tour[i])) * (k / 20.0);
            const dat::EnvCell* cell = cellAt(p);
            if (cell == nullptr)
                EXPECT_GT(p.z, ground(p) + 1.0) << "under the ground outside";
            if (cell == last)
                continue;
            // The space changes near an opening between the two, well inside its border.
            const dat::EnvCell* from = last != nullptr ? last : cell;
            const dat::EnvCell* to = last != nullptr ? cell : nullptr;
            bool through = false;
            for (std::size_t n = 0; n < from->portals.size(); ++n) {
                const std::uint32_t other = from->portals[n].otherCellId;
                const bool leads = to == nullptr ? other == dat::kOutdoors : other == (to->id & 0xFFFF);
                const std::vector<Vec3> polygon = portalPoints(*from, n);
                const Plane plane = planeOf(polygon);
                const Vec3 local = inBlock(blockOf(from->id), p);
                through = through || (leads && std::abs(plane.signedDistance(local)) < 0.1 &&
                                      containsProjection(polygon, plane.n, local, -0.1));
            }
            EXPECT_TRUE(through) << "at way point " << i;
            if (cell != nullptr)
                visited.push_back(cell->id);
            last = cell;
        }
    }
    EXPECT_EQ(ofVillage(visited), expectedVillageVisits());
    const auto passes = [&](const std::vector<std::uint32_t>& way) {
        return std::search(visited.begin(), visited.end(), way.begin(), way.end()) != visited.end();
    };
    EXPECT_TRUE(passes({0xA9B50100, 0xA9B50101, 0xA9B50102, 0xA9B50103, 0xA9B50104})) << "up the tower";
    EXPECT_TRUE(passes({0xAAB50100, 0xAAB50101, 0xAAB50102, 0xAAB50103, 0xAAB50104, 0xAAB50105, 0xAAB50106}))
        << "into the cave";
    const auto placeCell = [&](const char* name) {
        return std::stoul(world().worldFile.at("places").at(name).at("cell").get<std::string>(), nullptr, 16);
    };
    EXPECT_EQ(std::count(visited.begin(), visited.end(), placeCell("dungeon.hub")), 1);
    EXPECT_EQ(visited.back(), placeCell("dungeon.pit"));
}

} // namespace
} // namespace limen::worlds::test
