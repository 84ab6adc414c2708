#include "doctor/retail/Judges.h"
#include "world/terrain/Terrain.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kLandSource = "test of a public client against the files";
using FoundNumbers = std::optional<Numbers>;

struct IndexedFact {
    std::size_t index;
    double value;
};
constexpr std::array<IndexedFact, 5> kHeightTable{{{0, 0}, {1, 2}, {100, 200}, {200, 400}, {255, 700}}};
constexpr std::array<IndexedFact, 5> kHeights9AB1{{{0, 120}, {1, 139}, {40, 93}, {79, 93}, {80, 110}}};
constexpr dat::RecordId kBlock9AB1 = 0x9AB1FFFF, kBlockA9B4 = 0xA9B4FFFF;

/// The codes of blend maps, in their order.
Numbers codesOf(const std::vector<dat::AlphaMap>& maps) {
    Numbers codes;
    for (const dat::AlphaMap& map : maps)
        codes.push_back(map.code);
    return codes;
}

void judgeHeightTable(const Result<dat::Region>& region, Ledger& ledger) {
    for (const IndexedFact& fact : kHeightTable)
        ledger.judgeRecord(
            region, Fact{fmt::format("land.height.{}", fact.index), kLandSource, {fact.value}},
            [&](const dat::Region& r) { return someNumbers({r.landDefs.heights[fact.index]}); });
    ledger.judgeRecord(region, Fact{"land.height.linearTo200", kLandSource, {201}}, [](const dat::Region& r) {
        double count = 0;
        for (std::size_t i = 0; i <= 200; ++i)
            count += r.landDefs.heights[i] == 2.0f * static_cast<float>(i);
        return someNumbers({count});
    });
    ledger.judgeRecord(region, Fact{"land.height.rises", kLandSource, {255}}, [](const dat::Region& r) {
        double count = 0;
        for (std::size_t i = 1; i < r.landDefs.heights.size(); ++i)
            count += r.landDefs.heights[i] > r.landDefs.heights[i - 1];
        return someNumbers({count});
    });
    ledger.judgeRecord(region, Fact{"land.height.201", kLandSource, {402.0001}}.by(Rule::AtLeast),
                       [](const dat::Region& r) { return someNumbers({r.landDefs.heights[201]}); });
}

void judgeTextures(const Result<dat::Region>& region, Ledger& ledger) {
    const auto line = [&](const char* name, Numbers expected, auto&& read) {
        ledger.judgeRecord(region, Fact{std::string("land.") + name, kLandSource, std::move(expected)},
                           [&](const dat::Region& r) { return FoundNumbers(read(r)); });
    };
    line("baseSize", {1024},
         [](const dat::Region& r) { return Numbers{static_cast<double>(r.texMerge.baseTexSize)}; });
    line("textures", {33},
         [](const dat::Region& r) { return Numbers{static_cast<double>(r.texMerge.textures.size())}; });
    line("cornerCodes", {8, 8, 8, 8}, [](const dat::Region& r) { return codesOf(r.texMerge.corners); });
    line("sideCodes", {9}, [](const dat::Region& r) { return codesOf(r.texMerge.sides); });
    line("roadCodes", {9, 10, 8}, [](const dat::Region& r) { return codesOf(r.texMerge.roads); });
    line("terrainTypes", {32},
         [](const dat::Region& r) { return Numbers{static_cast<double>(r.terrainTypes.size())}; });
    line("typesWith32Scenes", {32}, [](const dat::Region& r) {
        return Numbers{static_cast<double>(
            std::count_if(r.terrainTypes.begin(), r.terrainTypes.end(),
                          [](const dat::TerrainType& type) { return type.sceneTypes.size() == 32; }))};
    });
    ledger.judgeRecord(
        region, Fact{"land.unusedPart", "format survey of the archive", {1}}, [](const dat::Region& r) {
            return someNumbers(
                {(r.partsMask & 8u) != 0 ? 1.0 : 0.0}); // the part's bit is set, and nothing is stored
        });
}

void judgeBlocks(const dat::Archive& archive, const Result<dat::Region>& region, Ledger& ledger) {
    const auto land = archive.load<dat::LandBlock>(kBlock9AB1);
    for (const IndexedFact& fact : kHeights9AB1) {
        ledger.judgeRecord(land,
                           Fact{fmt::format("land.9AB1.index.{}", fact.index), kLandSource, {fact.value}},
                           [&](const dat::LandBlock& block) {
                               return someNumbers({static_cast<double>(block.heights[fact.index])});
                           });
        ledger.judgeRecord(
            land, Fact{fmt::format("land.9AB1.metres.{}", fact.index), kLandSource, {2 * fact.value}},
            [&](const dat::LandBlock& block) -> FoundNumbers {
                if (!region)
                    return std::nullopt;
                return Numbers{region->landDefs.heights[block.heights[fact.index]]};
            });
    }
    const auto holtburg = archive.load<dat::LandBlock>(kBlockA9B4);
    ledger.judgeRecord(
        holtburg, Fact{"land.A9B4.hasObjects", "first bytes of a record", {1}},
        [](const dat::LandBlock& block) { return someNumbers({static_cast<double>(block.hasObjects)}); });
    ledger.judgeRecord(holtburg, Fact{"land.A9B4.ground", kLandSource, {77.937}}.within(0.02),
                       [&](const dat::LandBlock& block) -> FoundNumbers {
                           if (!region)
                               return std::nullopt;
                           const world::Ground ground = world::groundOf(block, *region);
                           return Numbers{world::groundAt(ground.coord, ground.heights, 14.3926, 55.6124).z};
                       });
}

} // namespace

void judgeLand(const dat::Archive& archive, Ledger& ledger) {
    const Result<dat::Region> region = archive.load<dat::Region>(dat::kRegionId);
    judgeHeightTable(region, ledger);
    judgeTextures(region, ledger);
    judgeBlocks(archive, region, ledger);
}

} // namespace limen::doctor
