#include "demo/RegionBuilder.h"
#include "demo/generate/House.h"
#include "demo/generate/Kinds.h"
#include "demo/generate/Land.h"
#include "demo/generate/SmallPictures.h"

#include <fmt/format.h>

namespace limen::demo {

namespace {

constexpr dat::BlockCoord kSouthWestOfTown{0x50, 0x60};
constexpr int kGround = 40; ///< index of the level that the town lies about
constexpr std::uint32_t kColumns = 5, kRows = 4;
constexpr double kLot = 22.0;
constexpr std::size_t kMostPlaces = 48;

/// A row of houses along a street; metres from the middle of its landblock, before the district is turned.
struct Row {
    double y = 0.0;
    double turn = 0.0; ///< degrees; 0: the fronts look south
};
/// Two rows face each other across the street, two stand with their backs to those.
constexpr std::array<Row, kRows> kTownRows{{{5.0, 0.0}, {-5.0, 180.0}, {28.0, 180.0}, {-28.0, 0.0}}};
/// Where fences run between back gardens.
constexpr std::array<double, 2> kFences{16.5, -16.5};

class TownBuilder {
public:
    explicit TownBuilder(const GeneratedSpec& spec)
        : spec_(spec), random_(seedOf(spec)),
          blocks_((spec.size + kColumns * kRows - 1) / (kColumns * kRows)), across_(acrossOf(blocks_)),
          land_(kSouthWestOfTown, across_,
                static_cast<int>((blocks_ + static_cast<std::uint32_t>(across_) - 1) /
                                 static_cast<std::uint32_t>(across_)),
                kGround) {}

    WorldRecords build() {
        addSmallMaterials(records_);
        props_ = addProps(sink_);
        leaves_ = addHouseLeaves(sink_);
        addRegion(sink_, addPlants(sink_));
        roll();
        for (std::uint32_t b = 0; b < blocks_; ++b) {
            const std::uint32_t houses = spec_.size / blocks_ + (b < spec_.size % blocks_ ? 1u : 0u);
            buildBlock(static_cast<int>(b) % across_, static_cast<int>(b) / across_, houses);
        }
        for (std::uint32_t b = blocks_; b < static_cast<std::uint32_t>(across_ * landBlocksY()); ++b) {
            PlanWriter(sink_, shapes_,
                       land_.blockAt(static_cast<int>(b) % across_, static_cast<int>(b) / across_))
                .finish();
        }
        land_.addTo(records_);
        records_.worldFile = notes_.take();
        return std::move(records_);
    }

private:
    static int acrossOf(std::uint32_t blocks) {
        int across = 1;
        while (static_cast<std::uint32_t>(across * across) < blocks) {
            ++across;
        }
        return across;
    }
    [[nodiscard]] int landBlocksY() const { return (land_.verticesY() - 1) / kCellsPerBlock; }

    /// Gentle ground: a step of the table here and there.
    void roll() {
        for (int vx = 0; vx < land_.verticesX(); ++vx) {
            for (int vy = 0; vy < land_.verticesY(); ++vy) {
                land_.setHeight(vx, vy, kGround + static_cast<int>(random_.below(4)));
                land_.setCover(vx, vy, random_.chance(0.3) ? TerrainKind::PackedDirt : TerrainKind::LushGrass,
                               false);
            }
        }
    }

    void buildBlock(int bx, int by, std::uint32_t houses) {
        const dat::BlockCoord coord = land_.blockAt(bx, by);
        const Vec3 corner(192.0 * bx, 192.0 * by, 0.0);
        PlanWriter block(sink_, shapes_, coord);
        constexpr std::array<double, 6> kAngles{0.0, 90.0, 17.0, 45.0, 128.5, 0.0};
        const Placement district{{96.0, 96.0, 0.0}, kAngles[random_.below(kAngles.size())]};
        for (std::uint32_t h = 0; h < houses; ++h) {
            const Row& row = kTownRows[h % kRows];
            const std::uint32_t column = h / kRows;
            const double x =
                kLot * (static_cast<double>((column + 2) % kColumns) - 2.0) + random_.between(-2.0, 2.0);
            Placement at{place(district, {x, row.y + random_.between(-0.75, 0.75), 0.0}),
                         district.turn + row.turn};
            if (random_.chance(0.3)) {
                at.turn += random_.between(-7.0, 7.0);
            }
            addHouse(block, coord, corner, at);
        }
        addFences(block, corner, district);
        block.finish();
        if (bx == 0 && by == 0) {
            notePlaces(coord, corner, district);
        }
    }

    void addHouse(PlanWriter& block, dat::BlockCoord coord, const Vec3& corner, Placement at) {
        const HouseSpec house = groundHouse(corner, at);
        House planned = planHouse(house, props_, random_);
        const std::vector<PlannedCell> cells = planned.plan.cells;
        const dat::RecordId first = block.add(std::move(planned.plan), at);
        noteDoors(planned.openings, leaves_, coord, at, first, random_, notes_);
        for (std::size_t c = 0; c < cells.size() && notes_.placeCount() < kMostPlaces; ++c) {
            const Vec3 target = c == 0 ? Vec3(0.0, 0.0, 1.2) : cells[c].eye + Vec3(0.3, 1.0, -0.1);
            notes_.addPlace(fmt::format("house.{}.{}", house_, c),
                            blockToGlobal(coord, place(at, cells[c].eye)),
                            blockToGlobal(coord, place(at, target)), first + static_cast<dat::RecordId>(c));
        }
        ++house_;
    }

    /// A house that stands above the ground everywhere, its walls below it; sets the placement's height.
    HouseSpec groundHouse(const Vec3& corner, Placement& at) {
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

    void addFences(PlanWriter& block, const Vec3& corner, const Placement& district) {
        for (const double y : kFences) {
            for (double x = -54.0; x < 54.0; x += 3.0) {
                Vec3 p = place(district, {x, y, 0.0});
                p.z = land_.heightAt(corner.x + p.x, corner.y + p.y);
                block.addObject({props_.fence, {p, district.turn}});
            }
        }
    }

    void notePlaces(dat::BlockCoord coord, const Vec3& corner, const Placement& district) {
        const auto at = [&](double x, double y, double up) {
            Vec3 p = place(district, {x, y, 0.0});
            p.z = land_.heightAt(corner.x + p.x, corner.y + p.y) + up;
            return blockToGlobal(coord, p);
        };
        notes_.addPlace("street", at(-58.0, 0.0, 1.7), at(0.0, 0.0, 2.0), 0);
        notes_.addPlace("above", at(-70.0, -60.0, 45.0), at(0.0, 0.0, 0.0), 0);
        notes_.addPlace("gardens", at(-54.0, 15.0, 1.7), at(0.0, 16.0, 1.5), 0);
    }

    GeneratedSpec spec_;
    Random random_;
    std::uint32_t blocks_;
    int across_;
    Land land_;
    WorldRecords records_;
    ModelSink sink_{records_};
    ShapeLibrary shapes_{records_};
    Props props_;
    HouseLeaves leaves_;
    WorldNotes notes_;
    std::uint32_t house_ = 0;
};

} // namespace

WorldRecords buildTown(const GeneratedSpec& spec) {
    return TownBuilder(spec).build();
}

} // namespace limen::demo
