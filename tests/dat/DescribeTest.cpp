#include "dat/Describe.h"
#include "dat/Hex.h"
#include "dat/RandomRecords.h"
#include "dat/RecordTypes.h"

#include <nlohmann/json.hpp>

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::dat {
namespace {

using testing::HasSubstr;

TEST(Describe, writesIdsInHexAndFloatsAsTheyWereMeant) {
    Surface s;
    s.type = Surface::kBase1Image | Surface::kAdditive;
    s.texture = 0x05001A9A;
    s.translucency = 0.1f;
    s.luminosity = std::numeric_limits<float>::quiet_NaN();
    const auto json = nlohmann::json::parse(describe(s));
    EXPECT_EQ(json["texture"], "0x05001A9A");
    EXPECT_EQ(json["flags"], nlohmann::json({"Base1Image", "Additive"}));
    EXPECT_EQ(json["translucency"].dump(), "0.1");
    EXPECT_EQ(json["luminosity"], "nan");
}

TEST(Describe, shortListsStandOnOneLine) {
    const Palette p{0x04000001, {{0xFF112233}, {0xFF445566}}};
    EXPECT_EQ(describe(p), "{\"kind\": \"Palette\", \"id\": \"0x04000001\", "
                           "\"colours\": [\"#FF112233\", \"#FF445566\"]}");
    const Palette longer{0x04000001, std::vector<Colour>(20, Colour{1})};
    EXPECT_THAT(describe(longer), HasSubstr("\n  \"id\": \"0x04000001\",\n"));
}

TEST(Describe, textIsWindows1252) {
    Region r;
    r.name = "caf\xE9 \x80";
    EXPECT_EQ(nlohmann::json::parse(describe(r))["name"], "caf\xC3\xA9 \xE2\x82\xAC");
}

TEST(Describe, mapRowsLookLikeTheMap) {
    LandBlock b;
    b.heights[0] = 7; // south-west
    b.terrain[8] = 0x34;
    const auto json = nlohmann::json::parse(describe(b));
    EXPECT_EQ(json["heights"][8][0], 7);
    EXPECT_EQ(json["terrain_types"][0][0], 13);
}

template <class Record>
class DescribeEvery : public testing::Test {};
TYPED_TEST_SUITE(DescribeEvery, RecordTypes::As<testing::Types>);

TYPED_TEST(DescribeEvery, isJsonWhateverTheRecordHolds) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto text = describe(RandomRecords(seed).make<TypeParam>());
        EXPECT_TRUE(nlohmann::json::accept(text)) << text.substr(0, 400);
    }
}

TEST(Describe, decodesByFileAndId) {
    const Bytes palette = hex("01 00 00 04  01 00 00 00  33 22 11 FF");
    const auto described = describe(FileRole::Portal, 0x04000001, palette);
    ASSERT_TRUE(described);
    EXPECT_THAT(*described, HasSubstr("#FF112233"));
    EXPECT_FALSE(describe(FileRole::Portal, 0x04000001, ByteView(palette).first(9)));
    EXPECT_THAT(describe(FileRole::Local, 0x04000001, palette).value(), HasSubstr("01 00 00 04 01"));
    EXPECT_THAT(describe(FileRole::Cell, kIterationId, hex("05 00 00 00 FB FF FF FF 01 00 00 00")).value(),
                testing::AllOf(HasSubstr("[5, -5, 1]"), HasSubstr("\"count\": 5")));
}

} // namespace
} // namespace limen::dat
