#include "worlds/generate/TownBlocks.h"

#include <fmt/format.h>

namespace limen::worlds {

namespace {

constexpr std::uint32_t kColumns = kMostHouses / 4, kRows = 4;
constexpr double kLot = 22.0;
constexpr std::size_t kMostTownPlaces = 48;

/// A row of houses along a street, in metres from the middle of the landblock, before the district is turned.
struct Row {
    double y = 0.0;
    double turn = 0.0; ///< degrees; 0: the fronts look south
};
/// Two rows face each other across the street; behind each is a row back to back with it.
constexpr std::array<Row, kRows> kTownRows{{{5.0, 0.0}, {-5.0, 180.0}, {28.0, 180.0}, {-28.0, 0.0}}};
/// y of the fences between back gardens.
constexpr std::array<double, 2> kFences{16.5, -16.5};

} // namespace

Placement TownBlocks::build(int bx, int by, std::uint32_t houses) {
    const dat::BlockCoord coord = land_.blockAt(bx, by);
    const Vec3 corner(192.0 * bx, 192.0 * by, 0.0);
    LandblockWriter block(tools_.writer, coord, kGeneratedCells);
    constexpr std::array<double, 6> kAngles{0.0, 90.0, 17.0, 45.0, 128.5, 0.0};
    const Placement district{{96.0, 96.0, 0.0}, kAngles[random_.below(kAngles.size())]};
    for (std::uint32_t h = 0; h < houses; ++h) {
        const Row& row = kTownRows[h % kRows];
        const std::uint32_t column = h / kRows;
        const double x =
            kLot * (static_cast<double>((column + 2) % kColumns) - 2.0) + random_.between(-2.0, 2.0);
        Placement at{place(district, {x, row.y + random_.between(-0.75, 0.75), 0.0}),
                     district.turn + row.turn};
        if (random_.chance(0.3))
            at.turn += random_.between(-7.0, 7.0);
        addHouse(block, coord, corner, at);
    }
    addFences(block, corner, district);
    block.finish();
    return district;
}

void TownBlocks::addHouse(LandblockWriter& block, dat::BlockCoord coord, const Vec3& corner, Placement at) {
    const HouseSpec house = groundHouse(corner, at);
    House planned = planHouse(house, tools_.props, random_);
    const std::vector<CellPlan> cells = planned.plan.cells;
    const dat::RecordId first = block.add(withClosedSeams(std::move(planned.plan)), at).front();
    if (tools_.notes.doorCount() < tools_.mostDoors)
        noteDoors(planned.openings, tools_.leaves, coord, at, first, random_, tools_.notes);
    for (std::size_t c = 0; c < cells.size() && tools_.notes.placeCount() < kMostTownPlaces; ++c) {
        const Vec3 target = c == 0 ? Vec3(0.0, 0.0, 1.2) : cells[c].eye + Vec3(0.3, 1.0, -0.1);
        tools_.notes.addPlace(fmt::format("house.{}.{}", house_, c),
                              blockToGlobal(coord, place(at, cells[c].eye)),
                              blockToGlobal(coord, place(at, target)), first + static_cast<dat::RecordId>(c));
    }
    cells_ += static_cast<std::uint32_t>(cells.size());
    ++house_;
}

HouseSpec TownBlocks::groundHouse(const Vec3& corner, Placement& at) {
    HouseSpec house = randomHouse(random_, -1.0);
    double low = 1e9, high = -1e9;
    for (double x = -house.halfWidth - 0.5; x <= house.halfWidth + 0.5; x += 0.5) {
        for (double y = -0.5; y <= house.depth + 0.5; y += 0.5) {
            const Vec3 p = corner + place(at, {x, y, 0.0});
            const double z = land_.heightAt(p.x, p.y);
            low = std::min(low, z);
            high = std::max(high, z);
        }
    }
    at.origin.z = std::ceil(high * 8.0) / 8.0 + 0.125;
    house.foot = std::floor(low - at.origin.z - 0.5);
    return house;
}

void TownBlocks::addFences(LandblockWriter& block, const Vec3& corner, const Placement& district) {
    for (const double y : kFences) {
        for (double x = -54.0; x < 54.0; x += 3.0) {
            Vec3 p = place(district, {x, y, 0.0});
            p.z = land_.heightAt(corner.x + p.x, corner.y + p.y);
            block.addObject({tools_.props.fence, {p, district.turn}});
        }
    }
}

} // namespace limen::worlds
