#include "dat/Describe.h"
#include "dat/Hex.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

// Bytes by hand, after docs/formats/textures.md and docs/formats/geometry.md.
namespace limen::dat {
namespace {

TEST(PaletteSetCodec, readsNoneAndSome) {
    const Bytes none = hex("07 00 00 0F  00 00 00 00");
    const auto empty = decode<PaletteSet>(0x0F000007, none);
    ASSERT_TRUE(empty) << empty.error().message();
    EXPECT_EQ(*encode(*empty), none);
    const Bytes bytes = hex("07 00 00 0F  02 00 00 00  01 00 00 04  0A 00 00 04");
    const auto s = decode<PaletteSet>(0x0F000007, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->palettes, (std::vector<std::uint32_t>{0x04000001, 0x0400000A}));
    EXPECT_EQ(*encode(*s), bytes);
}

TEST(ClothingTableCodec, readsTheLeastThereCanBe) {
    const Bytes bytes = hex("01 00 00 10  00 00 20 00  00 00 20 00");
    const auto t = decode<ClothingTable>(0x10000001, bytes);
    ASSERT_TRUE(t) << t.error().message();
    EXPECT_EQ(t->parts.buckets, 32);
    EXPECT_EQ(*encode(*t), bytes);
}

TEST(ClothingTableCodec, readsPartsTexturesAndPalettes) {
    const Bytes bytes = hex(R"(
        01 00 00 10
        02 00  08 00                                              # two models, eight buckets
        01 00 00 02  01 00 00 00                                  # 02000001, one part:
        09 00 00 00  34 12 00 01                                  #   9 becomes 01001234
        01 00 00 00  11 00 00 05  22 00 00 05                     #   on it 05000022 for 05000011
        4E 00 00 02  00 00 00 00                                  # 0200004E, none
        01 00  20 00                                              # one palette template, 32 buckets
        0E 00 00 00  BB AA 00 06  01 00 00 00                     # 14, icon 0600AABB, one change:
        02 00 00 00  50 00 00 00 0C 00 00 00  A8 00 00 00 08 00 00 00   # colours 80..91, 168..175
        2F 00 00 0F                                               # from 0F00002F
    )");
    const auto t = decode<ClothingTable>(0x10000001, bytes);
    ASSERT_TRUE(t) << t.error().message();
    ASSERT_EQ(t->parts.entries.size(), 2u);
    EXPECT_EQ(t->parts.buckets, 8);
    EXPECT_EQ(t->parts.entries[0].first, 0x02000001u);
    const PartChange& change = t->parts.entries[0].second.at(0);
    EXPECT_EQ(change.part, 9u);
    EXPECT_EQ(change.gfxObj, 0x01001234u);
    EXPECT_EQ(change.textures.at(0).from, 0x05000011u);
    EXPECT_EQ(change.textures[0].to, 0x05000022u);
    const PaletteTemplate& colours = t->palettes.entries.at(0).second;
    EXPECT_EQ(colours.icon, 0x0600AABBu);
    EXPECT_EQ(colours.changes.at(0).ranges.at(1).offset, 168u);
    EXPECT_EQ(colours.changes[0].palettes, 0x0F00002Fu);
    EXPECT_EQ(*encode(*t), bytes);
    const auto json = nlohmann::json::parse(describe(*t));
    EXPECT_EQ(json["parts"][0]["changes"][0]["textures"][0]["to"], "0x05000022");
    EXPECT_EQ(json["palettes"][0]["changes"][0]["ranges"][0]["count"], 12);
}

TEST(DegradeInfoCodec, readsNoneAndSome) {
    const Bytes none = hex("EF 00 00 11  00 00 00 00");
    const auto empty = decode<DegradeInfo>(0x110000EF, none);
    ASSERT_TRUE(empty) << empty.error().message();
    EXPECT_EQ(*encode(*empty), none);
    const Bytes bytes = hex(R"(
        EF 00 00 11  02 00 00 00
        34 12 00 01  01 00 00 00  00 00 00 00  00 00 A0 41  00 00 20 42     # 01001234, a mesh, 0, 20, 40 m
        35 12 00 01  02 00 00 00  00 00 20 42  00 00 A0 42  00 00 C8 42     # 01001235, a sprite, 40, 80, 100 m
    )");
    const auto d = decode<DegradeInfo>(0x110000EF, bytes);
    ASSERT_TRUE(d) << d.error().message();
    ASSERT_EQ(d->levels.size(), 2u);
    EXPECT_EQ(d->levels[0].gfxObj, 0x01001234u);
    EXPECT_EQ(d->levels[0].maxDistance, 40.0f);
    EXPECT_NE(d->levels[1].mode, DegradeLevel::kMesh);
    EXPECT_EQ(d->levels[1].idealDistance, 80.0f);
    EXPECT_EQ(*encode(*d), bytes);
    EXPECT_EQ(nlohmann::json::parse(describe(*d))["levels"][1]["gfx_obj"], "0x01001235");
}

} // namespace
} // namespace limen::dat
