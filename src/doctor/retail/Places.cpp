#include "doctor/retail/Judges.h"
#include "world/terrain/Terrain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kPlaceList = "published list of places";
constexpr double kBelowGround = 0.5; // metres; positions of the list are rounded, and some float in water
constexpr double kOutsideCell = 0.5; // metres

/// A position in a landblock's frame, metres.
struct PlaceFact {
    std::uint32_t cell;
    double x, y, z;
    bool agrees = true; ///< the cell is that of the position
};
constexpr auto kPlaces = std::to_array<PlaceFact>({
    {0x00070143, 70, -60, 0.005},
    {0x01110108, 10, -10, 0},
    {0x013A02AE, 140, -40, 12},
    {0x016C01BC, 49.206, -31.935, 0.005},
    {0x018A024F, 120, -79.9, 0},
    {0x01E901C2, 152.333, -2.372, -12},
    {0x0FB90009, 43, 8.6, 0.005},
    {0x1133001F, 88.1, 166.2, 64.8},
    {0x17B2002A, 132.623, 25.809, 44.005},
    {0x1DB60016, 71.3873, 134.291, 90.005},
    {0x21B00017, 48.19, 165.89, 0.005},
    {0x23DA002C, 140.9, 86, 2.005},
    {0x2681001D, 77.7, 108.1, 240},
    {0x26EC003D, 175.927, 110.334, 80.005},
    {0x2B120029, 120.642, 1.549, 10.112},
    {0x2BB5003C, 178.958, 86.57, 0.005},
    {0x33D90015, 59.1, 100.3, 52.005},
    {0x38F7001B, 91, 54, -0.095},
    {0x3F310007, 23, 149.6, -0.1},
    {0x42DE000C, 25, 84.5, 0.005},
    {0x49B70021, 100.1, 20.8, 238.6},
    {0x49F00013, 70, 70, 170.005},
    {0x5A9C0004, 23.5, 77.1, 6},
    {0x64D5000B, 30, 50, 78},
    {0x7D64000D, 31.9, 104.6, 11.9},
    {0x80900013, 64.863, 55.687, 124.005},
    {0x8588002C, 120.359, 95.47, 90.049},
    {0x876C0008, 2, 186.9, 18},
    {0x8F58003B, 183.851, 60.183, 9.326},
    {0x934B0021, 108.3, 6.1, 18.1},
    {0x95D60033, 146.9, 71.3, 99.8},
    {0x9722003A, 168.354, 24.618, 102.005},
    {0x977B000C, 25.811, 73.853, 0.005},
    {0x9F440012, 90, 24.553, 31.885, false},
    {0xA0A40025, 96.302, 119.847, 59.955},
    {0xA21E001A, 83, 38, 560.4},
    {0xA260003C, 182.919, 87.934, 20.005},
    {0xA9B40019, 84, 7.1, 94},
    {0xB46F001E, 75.2, 124.1, 34.69},
    {0xBA170039, 181.2, 3.2, 167.7},
    {0xBB9F0040, 169.358, 168.251, 54.005},
    {0xBDD00006, 16.9, 120.5, 115.1},
    {0xC0800007, 11.723, 155.56, 33.028},
    {0xC6A90009, 46.805, 4.219, 42.005},
    {0xC95B0001, 14.8, 0.3, 12},
    {0xC98C0028, 113.666, 190.259, 22.005},
    {0xCE410007, 12.6, 152.8, 55.1},
    {0xCE940035, 151.053, 112.61, 17.417},
    {0xDA55001D, 84.8, 99, 20},
    {0xDA75002B, 132, 60, 18.005},
    {0xDC3C0011, 59.72, 10.774, 18.958},
    {0xE6320021, 107.417, 10.763, 29.908},
    {0xE63E0022, 96.96, 37.722, 74.542},
    {0xE64E002F, 138.304, 161.905, 20.04},
    {0xE822002A, 132.7, 37.9, 20.1},
    {0xF224001A, 81.8, 33, 0},
    {0xF5590034, 152.59, 80.8, 20.005},
    {0xF6820033, 145.7, 49.855, 58.005},
});

bool isOutdoors(const PlaceFact& place) {
    return (place.cell & 0xFFFFu) < dat::kFirstCell;
}

/// Low word of the landcell at a position of a landblock.
double landcellAt(double x, double y) {
    return 8 * std::floor(x / world::kLandcellSize) + std::floor(y / world::kLandcellSize) + 1;
}

/// The distance of a block-local point from the box around a cell, in the cell's own axes, metres.
double distanceFrom(const dat::EnvCell& cell, const dat::CellStruct& shape, const Vec3f& point) {
    Vec3f least(1e9f), most(-1e9f);
    for (const auto& [key, vertex] : shape.vertexArray.vertices) {
        least = glm::min(least, vertex.position);
        most = glm::max(most, vertex.position);
    }
    const Vec3f local = glm::conjugate(cell.position.orientation) * (point - cell.position.origin);
    return glm::length(local - glm::clamp(local, least, most));
}

void judgeOutdoorPlace(const dat::Archive& archive, const Result<dat::Region>& region, const PlaceFact& place,
                       Ledger& ledger) {
    const std::string prefix = fmt::format("place.{:08X}.", place.cell);
    const dat::BlockCoord block = dat::blockOf(place.cell);
    if (place.agrees)
        ledger.judge(Fact{prefix + "landcell", kPlaceList, {static_cast<double>(place.cell & 0xFFFFu)}}.hex(),
                     Numbers{landcellAt(place.x, place.y)});
    ledger.judgeRecord(archive.load<dat::LandBlock>(dat::landBlockId(block)),
                       Fact{prefix + "aboveGround", kPlaceList, {-kBelowGround}}.by(Rule::AtLeast),
                       [&](const dat::LandBlock& land) -> std::optional<Numbers> {
                           if (!region)
                               return std::nullopt;
                           const world::Ground ground = world::groundOf(land, *region);
                           return Numbers{place.z -
                                          world::groundAt(block, ground.heights, place.x, place.y).z};
                       });
}

void judgeIndoorPlace(const dat::Archive& archive, const PlaceFact& place, Ledger& ledger) {
    ledger.judgeRecord(
        archive.load<dat::EnvCell>(place.cell),
        Fact{fmt::format("place.{:08X}.inCell", place.cell), kPlaceList, {kOutsideCell}}.by(Rule::AtMost),
        [&](const dat::EnvCell& cell) -> std::optional<Numbers> {
            const auto shapes = archive.load<dat::Environment>(0x0D000000u | cell.environment);
            if (!shapes)
                return std::nullopt;
            const auto shape = std::find_if(shapes->cells.begin(), shapes->cells.end(),
                                            [&](const auto& s) { return s.first == cell.cellStructure; });
            if (shape == shapes->cells.end() || shape->second.vertexArray.vertices.empty())
                return std::nullopt;
            return Numbers{distanceFrom(cell, shape->second, Vec3f(place.x, place.y, place.z))};
        });
}

} // namespace

void judgePlaces(const dat::Archive& archive, Ledger& ledger) {
    const Result<dat::Region> region = archive.load<dat::Region>(dat::kRegionId);
    for (const PlaceFact& place : kPlaces)
        if (isOutdoors(place))
            judgeOutdoorPlace(archive, region, place, ledger);
        else
            judgeIndoorPlace(archive, place, ledger);
}

} // namespace limen::doctor
