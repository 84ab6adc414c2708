#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/generate/DungeonBlock.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/SmallPictures.h"
#include "worlds/generate/TownBlocks.h"
#include "worlds/pictures/Noise.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace limen::worlds {

namespace {

constexpr int kAcross = 255; ///< landblocks of the map in each direction
constexpr int kVertices = kAcross * kCellsPerBlock;
/// Dungeons occupy the westernmost columns of landblocks, under the sea.
constexpr int kMostDungeonColumns = 64;
/// Cells of each dungeon; more if kMostDungeonColumns would not suffice.
constexpr std::uint32_t kDungeonCells = 200;
constexpr double kHouseShare = 0.05; ///< of the cells
constexpr std::size_t kMostMapDoors = 400;
constexpr std::size_t kDungeonsWithPlaces = 2;

/// Cells of noise across the map: mountains are some kilometres apart, with hills between them.
constexpr int kMountains = 12, kHills = 96;
constexpr double kSeaLevel = 30.0, kMountainRise = 70.0,
                 kHillRise = 12.0; ///< in indices of the Region's table
constexpr int kSandBelow = 34, kRockAbove = 90;
constexpr int kRoadEvery = 16; ///< landblocks from one road to the next

class MapBuilder {
public:
    explicit MapBuilder(const GeneratedSpec& spec)
        : spec_(spec), random_(seedOf(spec)), land_({0, 0}, kAcross, kAcross, 1) {
        const auto inDungeons = static_cast<std::uint32_t>(spec.size * (1.0 - kHouseShare));
        constexpr auto kRoom = static_cast<std::uint32_t>(kMostDungeonColumns * kAcross);
        dungeonCells_ = std::max(kDungeonCells, (inDungeons + kRoom - 1) / kRoom);
        dungeons_ = inDungeons / dungeonCells_;
        firstColumn_ = static_cast<int>((dungeons_ + kAcross - 1) / kAcross);
    }

    WorldRecords build() {
        addGeneratedMaterials(records_, spec_.furnished);
        props_ = addProps(writer_, spec_.furnished);
        houseLeaves_ = addHouseLeaves(writer_, spec_.furnished);
        dungeonLeaves_ = addDungeonLeaves(writer_, spec_.furnished);
        addRegion(writer_, addGeneratedPlants(writer_, spec_.furnished));
        raise();
        addTowns();
        land_.addTo(records_, [&](int bx, int by) { return !isDungeon(bx, by); });
        addDungeons();
        notePlaces();
        records_.worldFile = notes_.take();
        return std::move(records_);
    }

private:
    [[nodiscard]] bool isDungeon(int bx, int by) const {
        return static_cast<std::uint32_t>(bx * kAcross + by) < dungeons_;
    }

    void raise() {
        const auto seed = static_cast<std::uint32_t>(seedOf(spec_));
        for (int vx = 0; vx < land_.verticesX(); ++vx) {
            for (int vy = 0; vy < land_.verticesY(); ++vy) {
                const double u = static_cast<double>(vx) / kVertices, v = static_cast<double>(vy) / kVertices;
                const double mountain = std::max(0.0, fbm(u, v, kMountains, kMountains, 3, seed));
                const double hill = fbm(u, v, kHills, kHills, 2, seed + 1);
                const int index =
                    static_cast<int>(kSeaLevel + kMountainRise * mountain * mountain + kHillRise * hill);
                land_.setHeight(vx, vy, index);
                land_.setCover(vx, vy, coverOf(index, u, v, seed + 2), isRoad(vx, vy));
            }
        }
    }
    static TerrainKind coverOf(int index, double u, double v, std::uint32_t seed) {
        const double patch = fbm(u, v, 2 * kHills, 2 * kHills, 2, seed);
        if (index < kSandBelow)
            return patch > 0.2 ? TerrainKind::PackedDirt : TerrainKind::PatchyGrass;
        if (index > kRockAbove)
            return TerrainKind::BarrenRock;
        return patch > 0.25    ? TerrainKind::ForestFloor
               : patch > 0.0   ? TerrainKind::LushGrass
               : patch > -0.25 ? TerrainKind::Grassland
                               : TerrainKind::Moss;
    }
    static bool isRoad(int vx, int vy) {
        constexpr int kRoadSteps = kRoadEvery * kCellsPerBlock;
        return vx % kRoadSteps == kRoadSteps / 2 || vy % kRoadSteps == kRoadSteps / 2;
    }

    // Towns are at crossings and beside roads until there are enough cells. Other landblocks are empty.
    void addTowns() {
        TownBlocks towns({writer_, props_, houseLeaves_, notes_, kMostMapDoors}, land_, random_);
        const auto wanted = static_cast<std::uint32_t>(spec_.size * kHouseShare);
        std::set<std::pair<int, int>> built;
        while (towns.cells() < wanted && built.size() < kMostTownBlocks) {
            const int bx =
                firstColumn_ +
                static_cast<int>(random_.below(static_cast<std::uint32_t>(kAcross - firstColumn_)));
            const int by = static_cast<int>(random_.below(kAcross));
            if (built.insert({bx, by}).second) {
                level(bx, by);
                towns.build(bx, by, 1 + random_.below(kMostHouses));
                firstTown_ = built.size() == 1 ? land_.blockAt(bx, by) : firstTown_;
            }
        }
    }
    /// Makes the ground of a landblock nearly flat, for houses.
    void level(int bx, int by) {
        const int vx = bx * kCellsPerBlock, vy = by * kCellsPerBlock;
        const int middle = land_.heightIndexAt(vx + kCellsPerBlock / 2, vy + kCellsPerBlock / 2);
        for (int x = 1; x < kCellsPerBlock; ++x)
            for (int y = 1; y < kCellsPerBlock; ++y)
                land_.setHeight(vx + x, vy + y, middle + static_cast<int>(random_.below(2)));
    }

    void addDungeons() {
        const DungeonTools tools{writer_, dungeonShapes_, props_, dungeonLeaves_};
        for (std::uint32_t d = 0; d < dungeons_; ++d) {
            const dat::BlockCoord coord{static_cast<int>(d) / kAcross, static_cast<int>(d) % kAcross};
            const std::uint64_t seed = seedOf(spec_) ^ static_cast<std::uint64_t>(d + 1) << 40;
            WorldNotes unsaid;
            writeDungeonBlock(tools, coord, layOutDungeon(dungeonCells_, spec_.overlapShare, Random(seed)),
                              Random(~seed), d < kDungeonsWithPlaces ? notes_ : unsaid);
        }
    }

    void notePlaces() {
        const auto above = [&](const char* name, int bx, int by) {
            const Vec3 at(192.0 * bx + 96.0, 192.0 * by + 96.0, 0.0);
            const Vec3 eye(at.x, at.y, land_.heightAt(at.x, at.y) + 1.7);
            notes_.addPlace(name, eye, eye + Vec3(1.0, 0.3, 0.0), 0);
        };
        above("west", firstColumn_, kAcross / 2);
        above("middle", (firstColumn_ + kAcross) / 2, kAcross / 2);
        above("east", kAcross - 1, kAcross / 2);
        above("south", (firstColumn_ + kAcross) / 2, 0);
        above("north", (firstColumn_ + kAcross) / 2, kAcross - 1);
        if (firstTown_)
            above("town", firstTown_->x, firstTown_->y);
    }

    static constexpr std::size_t kMostTownBlocks = 20'000;

    GeneratedSpec spec_;
    Random random_;
    Land land_;
    std::uint32_t dungeonCells_ = 0, dungeons_ = 0;
    int firstColumn_ = 0; ///< of land
    WorldRecords records_;
    ModelWriter writer_{records_};
    ShapeLibrary shapes_{records_};
    DungeonShapes dungeonShapes_{shapes_};
    Props props_;
    HouseLeaves houseLeaves_;
    DungeonLeaves dungeonLeaves_;
    WorldNotes notes_;
    std::optional<dat::BlockCoord> firstTown_;
};

} // namespace

WorldRecords buildMap(const GeneratedSpec& spec) {
    return MapBuilder(spec).build();
}

} // namespace limen::worlds
