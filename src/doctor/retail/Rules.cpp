#include "doctor/retail/Judges.h"
#include "world/LandRandom.h"
#include "world/records/Records.h"
#include "world/terrain/Scenery.h"

#include <array>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kHashSource = "test of a public client, and our format notes";
constexpr const char* kSplitSource = "rule checked by a test of a public client";
constexpr const char* kRoadSource = "test of a public client";

struct HashFact {
    std::uint32_t x, y, seed, hash;
};
constexpr std::array<HashFact, 10> kHashes{{{0, 0, 0x5B67, 0xF4D7C05F},
                                            {1, 0, 0x5B67, 0xB2BBDCA2},
                                            {0, 1, 0x5B67, 0x60F285E6},
                                            {1352, 1440, 0x5B67, 0x16DC1C97},
                                            {1352, 1440, 0xB2CD, 0x3666E6AD},
                                            {1352, 1440, 0xF697, 0x6DF74D47},
                                            {0, 0, 0x2BF9, 0x7F8CDA01},
                                            {1, 0, 0x2BF9, 0x3D70F644},
                                            {0, 1, 0x2BF9, 0xEBA79F88},
                                            {1352, 1440, 0x2BF9, 0x4B261039}}};

/// The splits of a landblock's cells, as one byte a row from north to south. The highest bit is the western cell; a set
/// bit is a split from south-west to north-east.
struct SplitFact {
    std::uint32_t block;
    std::array<std::uint8_t, 8> rows;
};
constexpr std::array<SplitFact, 8> kSplits{{
    {0xA9B4, {0xFF, 0xFF, 0xE0, 0xC1, 0xC7, 0xCC, 0x99, 0x9B}},
    {0xC6A9, {0x5B, 0x29, 0xB5, 0x55, 0xAD, 0x6B, 0xDA, 0xB2}},
    {0xBB9F, {0x92, 0xA5, 0x2A, 0x55, 0x4A, 0xAD, 0x96, 0xD9}},
    {0xDA55, {0x1F, 0xFF, 0x00, 0xC0, 0x78, 0x9C, 0xC6, 0x36}},
    {0x7D64, {0x80, 0xFF, 0x01, 0xF0, 0x0E, 0x63, 0x98, 0x66}},
    {0x7209, {0x93, 0xB6, 0xA5, 0xAA, 0xAA, 0xA5, 0x94, 0x92}},
    {0xC5F0, {0x00, 0xFF, 0xF0, 0x87, 0x1C, 0x73, 0x6C, 0xDB}},
    {0x9AB1, {0x1E, 0x18, 0x33, 0x36, 0x24, 0xA9, 0xAA, 0xAA}},
}};

/// Corners with a road: A SW, B NW, C SE, D NE.
struct RoadFact {
    const char* corners;
    double x, y;
    bool isOn;
};
constexpr auto kRoads = std::to_array<RoadFact>({
    {"A", 1, 1, true},      {"A", 12, 12, false},    {"B", 1, 23, true},       {"C", 23, 1, true},
    {"D", 23, 23, true},    {"AB", 1, 12, true},     {"AC", 12, 1, true},      {"CD", 23, 12, true},
    {"BD", 12, 23, true},   {"AD", 12, 12, true},    {"AD", 2, 22, false},     {"BC", 12, 12, true},
    {"BC", 2, 2, false},    {"ABC", 1, 20, true},    {"ABD", 12, 23, true},    {"ACD", 12, 1, true},
    {"BCD", 12, 23, true},  {"ABCD", 12, 12, true},  {"", 12, 12, false},      {"AB", 4.999, 12, true},
    {"AB", 5.0, 12, false}, {"CD", 19.0, 12, false}, {"CD", 19.001, 12, true},
});

constexpr std::uint32_t kMapCells = 2040; // along one side

void judgeHashes(Ledger& ledger) {
    for (const HashFact& fact : kHashes)
        ledger.judge(Fact{fmt::format("rule.hash.{}.{}.{:X}", fact.x, fact.y, fact.seed),
                          kHashSource,
                          {static_cast<double>(fact.hash)}}
                         .hex(),
                     Numbers{static_cast<double>(world::landHash(fact.x, fact.y, fact.seed))});
    const double motion = dat::motionKey(0x8000003D, 0x41000003);
    ledger.judge(Fact{"rule.motionKey", kHashSource, {0x003D0003}}.hex(), Numbers{motion});
}

Numbers splitRows(std::uint32_t block) {
    const std::uint32_t x = (block >> 8) * 8, y = (block & 0xFFu) * 8;
    Numbers rows;
    for (std::uint32_t row = 0; row < 8; ++row) {
        std::uint32_t bits = 0;
        for (std::uint32_t column = 0; column < 8; ++column)
            bits = bits << 1 | (world::splitsSouthWestNorthEast(x + column, y + 7 - row) ? 1u : 0u);
        rows.push_back(bits);
    }
    return rows;
}

void judgeSplits(Ledger& ledger) {
    for (const SplitFact& fact : kSplits)
        ledger.judge(Fact{fmt::format("rule.split.{:04X}", fact.block), kSplitSource,
                          Numbers(fact.rows.begin(), fact.rows.end())},
                     splitRows(fact.block));
    double count = 0;
    for (std::uint32_t x = 0; x < kMapCells; ++x)
        for (std::uint32_t y = 0; y < kMapCells; ++y)
            count += world::splitsSouthWestNorthEast(x, y);
    ledger.judge(Fact{"rule.split.wholeMap", kSplitSource, {2081396}}, Numbers{count});
}

void judgeRoads(Ledger& ledger) {
    for (const RoadFact& fact : kRoads) {
        world::Ground ground;
        for (const char corner : std::string_view(fact.corners)) {
            const std::size_t x = corner == 'C' || corner == 'D', y = corner == 'B' || corner == 'D';
            ground.words[x * 9 + y] = 1;
        }
        const bool found = world::isOnRoad(ground, fact.x, fact.y);
        ledger.judge(Fact{fmt::format("rule.road.{}.{:g}.{:g}", *fact.corners != 0 ? fact.corners : "none",
                                      fact.x, fact.y),
                          kRoadSource,
                          {fact.isOn ? 1.0 : 0.0}},
                     Numbers{found ? 1.0 : 0.0});
    }
}

} // namespace

void judgeRules(Ledger& ledger) {
    judgeHashes(ledger);
    judgeSplits(ledger);
    judgeRoads(ledger);
}

} // namespace limen::doctor
