#include "engine/places/FoundPlaces.h"

#include "core/Assert.h"
#include "core/Nearest.h"
#include "engine/ViewRequest.h"
#include "engine/map/MapCoordinates.h"
#include "engine/places/BlockIndex.h"
#include "engine/places/KnownSpots.h"
#include "engine/places/MadeTour.h"
#include "engine/places/Viewpoints.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace limen::engine {
namespace {

constexpr std::size_t kMostPlaces = 5000;
constexpr std::uint32_t kCellsLookedAt = 24;          // per dungeon: enough for a hall near its first cell
constexpr double kGoodView = 8.0;                     // a CellViewpoint's score that ends the search
constexpr double kNearMiddle = 40.0 * 192.0;          // metres over which a town's rank falls by e
constexpr double kSpotBelow = 3.0, kSpotAbove = 15.0; // metres from the ground to a known spot's feet

/// Finds the places of one archive.
class Search {
public:
    Search(const dat::Archive& archive, std::vector<BlockFacts> blocks, const SearchProgress& progress)
        : shapes_(archive), blocks_(std::move(blocks)), towns_(findTowns(blocks_)), progress_(progress) {
        for (std::size_t town = 0; town < towns_.size(); ++town)
            for (const std::size_t block : towns_[town].blocks)
                townOf_[dat::blockWord(blocks_[block].coord)] = town;
    }

    /// No value: the search was ended.
    std::optional<world::WorldFile> run() {
        const std::vector<Town> ranked = rankedTowns();
        const std::vector<const BlockFacts*> dungeons = largestDungeons();
        all_ = 1 + ranked.size() + dungeons.size() + 1; // the spots, and the tour
        addSpots();
        bool goesOn = step();
        for (std::size_t i = 0; goesOn && i < ranked.size(); ++i) {
            addTown(ranked[i]);
            goesOn = step();
        }
        for (std::size_t i = 0; goesOn && i < dungeons.size(); ++i) {
            addDungeon(*dungeons[i]);
            goesOn = step();
        }
        if (!goesOn)
            return std::nullopt;
        if (file_.places.empty())
            addLand();
        chooseStart();
        LIMEN_ASSERT(file_.places.empty() || startPlace(), "the start is one of the places");
        file_.tour = makeTour(shapes_, startPlace(), dungeonPlace());
        step();
        return std::move(file_);
    }

private:
    /// Counts a step. False: the search ends.
    bool step() { return !progress_ || progress_(++done_, all_); }

    std::vector<const BlockFacts*> largestDungeons() const {
        std::vector<const BlockFacts*> dungeons;
        for (const BlockFacts& block : blocks_)
            if (block.cells > 0 && block.buildings == 0)
                dungeons.push_back(&block);
        std::stable_sort(dungeons.begin(), dungeons.end(),
                         [](const BlockFacts* a, const BlockFacts* b) { return a->cells > b->cells; });
        return dungeons;
    }

    /// Large ones first, and those near the middle of the land before equal ones far away.
    std::vector<Town> rankedTowns() {
        const Vec3 middle = middleOfLand(blocks_);
        const auto rank = [&](const Town& town) {
            const Vec3 way = town.middle - middle;
            return town.buildings * std::exp(-std::hypot(way.x, way.y) / kNearMiddle);
        };
        std::vector<Town> ranked = towns_;
        std::stable_sort(ranked.begin(), ranked.end(),
                         [&](const Town& a, const Town& b) { return rank(a) > rank(b); });
        return ranked;
    }

    void add(world::Place place, std::string name) {
        if (file_.places.size() >= kMostPlaces || !names_.insert(plainName(name)).second)
            return;
        place.name = std::move(name);
        file_.places.push_back(std::move(place));
    }

    /// A spot counts if this world has its cell, or a town there and ground at the height of its feet.
    void addSpots() {
        for (const KnownSpot& spot : knownSpots()) {
            const dat::BlockCoord coord = dat::blockOf(spot.cell);
            const Vec3 feet = originOf(coord) + spot.feet;
            if (!spot.isOutdoors()) {
                addSpotInside(spot, feet);
                continue;
            }
            const double above = feet.z - shapes_.ground(feet.x, feet.y);
            const std::optional<std::size_t> town = townAt(coord);
            if (!town || !(above > -kSpotBelow && above < kSpotAbove))
                continue;
            std::size_t block = towns_[*town].blocks.front();
            for (const std::size_t own : towns_[*town].blocks)
                block = blocks_[own].coord == coord ? own : block;
            if (auto place = beforeNearestBuilding(shapes_, shapes_.block(blocks_[block].coord), feet)) {
                add(std::move(*place), spot.name);
                named_.emplace(*town, spot.name);
            }
            shapes_.forget();
        }
    }

    void addSpotInside(const KnownSpot& spot, const Vec3& feet) {
        const CellShape* cell = shapes_.cell(spot.cell);
        if (cell == nullptr)
            return;
        const Vec3 eye = feet + Vec3(0.0, 0.0, kEyeHeight);
        const double floor = cell->solids.floorBelow(eye, kEyeHeight + 0.5);
        if (!std::isfinite(floor) || cell->solids.crowds(eye, 0.2))
            return; // another cell of the same number
        add({{}, {eye.x, eye.y, floor + kEyeHeight}, spot.yaw, 0.0, spot.cell}, spot.name);
        knownDungeons_.insert(spot.cell >> 16);
    }

    /// The town with a building in this block.
    [[nodiscard]] std::optional<std::size_t> townAt(dat::BlockCoord coord) const {
        const auto found = townOf_.find(dat::blockWord(coord));
        return found == townOf_.end() ? std::nullopt : std::optional(found->second);
    }

    void addTown(const Town& town) {
        const BlockFacts& main = blocks_[town.blocks.front()];
        if (const auto known = named_.find(townOf_.at(dat::blockWord(main.coord))); known != named_.end()) {
            firstTown_ = firstTown_.empty() ? known->second : firstTown_;
            return;
        }
        if (auto place = beforeNearestBuilding(shapes_, shapes_.block(main.coord), main.middle)) {
            const char* kind = town.buildings > 1 ? "town" : "house";
            const std::string name = fmt::format("{} {}", kind, mapText(Vec2(main.middle)));
            firstTown_ = firstTown_.empty() ? name : firstTown_;
            add(std::move(*place), name);
        }
        shapes_.forget();
    }

    void addDungeon(const BlockFacts& block) {
        std::optional<CellViewpoint> best;
        const dat::RecordId end =
            block.firstCell + std::min(block.cells, kCellsLookedAt); // cells are normally without gaps
        for (dat::RecordId id = block.firstCell; id < end && !(best && best->score > kGoodView); ++id) {
            const CellShape* cell = shapes_.cell(id);
            std::optional<CellViewpoint> inside = cell == nullptr ? std::nullopt : insideCell(*cell);
            if (inside && (!best || inside->score > best->score))
                best = std::move(inside);
        }
        if (best) {
            if (!dungeon_)
                dungeon_ = best->place;
            if (!knownDungeons_.contains(dat::blockWord(block.coord) >> 16))
                add(std::move(best->place),
                    fmt::format("dungeon {:02X}{:02X}", block.coord.x, block.coord.y));
        }
        shapes_.forget();
    }

    /// A world of land alone: above the ground at its middle, or at the block with land nearest to it.
    void addLand() {
        const Vec3 middle = middleOfLand(blocks_);
        const auto distance = [&](const BlockFacts& block) {
            const Vec3 way = originOf(block.coord) + Vec3(96.0, 96.0, 0.0) - middle;
            return block.hasLand ? std::hypot(way.x, way.y) : 1e300;
        };
        const auto nearestBlock =
            std::min_element(blocks_.begin(), blocks_.end(), [&](const BlockFacts& a, const BlockFacts& b) {
                return distance(a) < distance(b);
            });
        if (nearestBlock == blocks_.end())
            return;
        const Vec3 there = originOf(nearestBlock->coord) + Vec3(96.0, 96.0, 0.0);
        std::optional<world::Place> place = aboveGround(shapes_, middle.x, middle.y);
        if (!place)
            place = aboveGround(shapes_, there.x, there.y);
        if (place)
            add(std::move(*place), "land " + mapText(Vec2(place->eye)));
    }

    void chooseStart() {
        if (names_.contains(plainName(kKnownStart)))
            file_.start = kKnownStart;
        else if (!firstTown_.empty())
            file_.start = firstTown_;
        else if (const std::optional<world::Place> dungeon = dungeonPlace())
            file_.start = dungeon->name;
        else if (!file_.places.empty())
            file_.start = file_.places.front().name;
    }

    [[nodiscard]] std::optional<world::Place> startPlace() const {
        for (const world::Place& place : file_.places)
            if (place.name == file_.start)
                return place;
        return {};
    }

    /// The named place in the largest dungeon.
    [[nodiscard]] std::optional<world::Place> dungeonPlace() const {
        for (const world::Place& place : file_.places)
            if (dungeon_ && place.cell >> 16 == dungeon_->cell >> 16)
                return place;
        return {};
    }

    Shapes shapes_;
    std::vector<BlockFacts> blocks_;
    std::vector<Town> towns_;
    std::map<dat::RecordId, std::size_t> townOf_; ///< by block word
    world::WorldFile file_;
    std::set<std::string> names_;              ///< plain
    std::map<std::size_t, std::string> named_; ///< towns with a known name
    std::string firstTown_;                    ///< the name of the highest in the ranking
    std::set<std::uint32_t> knownDungeons_;    ///< block words >> 16
    std::optional<world::Place> dungeon_;      ///< in the largest dungeon
    const SearchProgress& progress_;
    std::size_t done_ = 0, all_ = 0; ///< steps
};

} // namespace

Result<world::WorldFile> findPlaces(const dat::Archive& archive, const SearchProgress& progress) {
    Result<std::vector<BlockFacts>> blocks = readBlockIndex(archive);
    if (!blocks)
        return Failure(blocks.error());
    std::optional<world::WorldFile> found = Search(archive, std::move(*blocks), progress).run();
    if (!found)
        return fail(ErrorCode::Unreadable, archive.directory().string(),
                    "the search for places was cancelled");
    return std::move(*found);
}

} // namespace limen::engine
