#include "dat/Hex.h"

#include <gtest/gtest.h>

namespace limen::dat {
namespace {

/// 256 heights of 2, a table that is easy to recognise.
std::string heights() {
    std::string out;
    for (int i = 0; i < 256; ++i)
        out += "00 00 00 40 ";
    return out;
}

const std::string kHead = R"(
    00 00 00 13  01 00 00 00  03 00 00 00  06 00 44 65 72 65 74 68            # id, number, version, "Dereth"
    FF 00 00 00  FF 00 00 00  00 00 C0 41  08 00 00 00  01 00 00 00           # 255 x 255 blocks, 24 m, 8, 1
    00 00 48 43  00 00 7A 44  00 00 A0 40                                     # 200, 1000, road 5
)" + heights() + R"(
    00 00 00 00 00 20 AC 40  0A 00 00 00  00 20 EE 45  68 01 00 00            # 3600.0, year 10, 7620 s, 360 days
    04 00 50 2E 59 2E 00 00                                                   # "P.Y." and two bytes of padding
    01 00 00 00  00 00 00 3F  01 00 00 00  05 00 4E 69 67 68 74 00            # night from 0.5
    01 00 00 00  00 00 00 00                                                  # one nameless day
    01 00 00 00  3C 00 00 00  01 00 57 00                                     # season "W" from day 60
)";

const std::string kTail = R"(
    01 00 00 00  02 00 41 42  44 33 22 11  01 00 00 00  05 00 00 00           # terrain "AB", one scene type
    00 00 00 00                                                               # texture merge
    00 04 00 00                                                               # base texture size
    01 00 00 00  08 00 00 00  01 00 00 05                                     # corner
    01 00 00 00  09 00 00 00  02 00 00 05                                     # side
    01 00 00 00  0A 00 00 00  03 00 00 05                                     # road
    01 00 00 00  20 00 00 00  04 00 00 05  02 00 00 00                        # road texture, tiling 2
        10 00 00 00 11 00 00 00 12 00 00 00 13 00 00 00 14 00 00 00 15 00 00 00  03 00 00 00  05 00 00 05
)";

TEST(RegionCodec, readsTheSmallestRegion) {
    const Bytes bytes = hex(kHead + "00 00 00 00" + kTail);
    const auto r = decode<Region>(kRegionId, bytes);
    ASSERT_TRUE(r) << r.error().message();
    EXPECT_EQ(r->name, "Dereth");
    EXPECT_EQ(r->version, 3u);
    EXPECT_EQ(r->landDefs.numBlockWidth, 255);
    EXPECT_EQ(r->landDefs.squareLength, 24.0f);
    EXPECT_EQ(r->landDefs.roadWidth, 5.0f);
    EXPECT_EQ(r->landDefs.heights[255], 2.0f);
    EXPECT_EQ(r->gameTime.zeroTimeOfYear, 3600.0);
    EXPECT_EQ(r->gameTime.dayLength, 7620.0f);
    EXPECT_EQ(r->gameTime.daysPerYear, 360u);
    EXPECT_EQ(r->gameTime.yearSpec, "P.Y.");
    EXPECT_EQ(r->gameTime.timesOfDay.at(0).name, "Night");
    EXPECT_EQ(r->gameTime.daysOfWeek.at(0), "");
    EXPECT_EQ(r->gameTime.seasons.at(0).startDay, 60u);
    EXPECT_EQ(r->terrainTypes.at(0).name, "AB");
    EXPECT_EQ(r->terrainTypes[0].colour.argb, 0x11223344u);
    EXPECT_EQ(r->terrainTypes[0].sceneTypes, std::vector<std::uint32_t>{5});
    EXPECT_EQ(r->texMerge.corners.at(0).code, 8u);
    EXPECT_EQ(r->texMerge.sides.at(0).texture, 0x05000002u);
    EXPECT_EQ(r->texMerge.roads.at(0).code, 10u);
    const TerrainTexture& road = r->texMerge.textures.at(0);
    EXPECT_EQ(road.terrainType, 0x20u);
    EXPECT_EQ(road.tiling, 2u);
    EXPECT_EQ(road.minHue, 0x15u);
    EXPECT_EQ(road.detailTexture, 0x05000005u);
    EXPECT_EQ(*encode(*r), bytes);
}

TEST(RegionCodec, readsItsPartsInTheOrderSkySoundScene) {
    const Bytes bytes = hex(kHead + R"(
        13 02 00 00                                                           # all parts
        00 00 00 00 00 00 F0 3F  00 00 00 00 00 00 00 40                      # ticks 1, 2
        01 00 00 00  00 00 80 3F  01 00 43 00                                 # a day group "C"
        01 00 00 00  00 00 00 00 00 00 80 3F  00 00 00 00 00 00 B4 42  00 00 00 00 00 00 00 3F
                     01 00 00 01  02 00 00 33  05 00 00 00                    # a sky object
        01 00 00 00  00 00 80 3E  00 00 80 3F  00 00 34 42  00 00 F0 41  30 20 10 FF
                     00 00 00 3F  60 50 40 FF  00 00 C8 42  00 00 48 43  90 80 70 FF  03 00 00 00
                     01 00 00 00  00 00 00 00  00 00 00 00  00 00 80 3F  00 00 00 40  00 00 40 40  00 00 80 40
        01 00 00 00  07 00 00 20  01 00 00 00  02 00 00 00  00 00 80 3F 00 00 00 40 00 00 40 40 00 00 80 40
        01 00 00 00  09 00 00 00  02 00 00 00  01 00 00 12  02 00 00 12       # a scene type with two scenes
    )" + kTail + "01 00 00 00  7D 12 00 06  61 02 00 06  04 00 00 00  DE 0F 00 01  12 16 00 01");
    const auto r = decode<Region>(kRegionId, bytes);
    ASSERT_TRUE(r) << r.error().message();
    EXPECT_EQ(r->sky.lightTickSize, 2.0);
    const DayGroup& group = r->sky.dayGroups.at(0);
    EXPECT_EQ(group.name, "C");
    EXPECT_EQ(group.objects.at(0).endAngle, 90.0f);
    EXPECT_EQ(group.objects[0].texVelocityY, 0.5f);
    EXPECT_EQ(group.objects[0].properties, 5u);
    const SkyTimeOfDay& time = group.times.at(0);
    EXPECT_EQ(time.begin, 0.25f);
    EXPECT_EQ(time.dirHeading, 45.0f);
    EXPECT_EQ(time.dirPitch, 30.0f);
    EXPECT_EQ(time.dirColour.argb, 0xFF102030u);
    EXPECT_EQ(time.ambColour.argb, 0xFF405060u);
    EXPECT_EQ(time.maxFog, 200.0f);
    EXPECT_EQ(time.fogMode, 3u);
    EXPECT_EQ(time.replaces.at(0).maxBright, 4.0f);
    EXPECT_EQ(r->sounds.at(0).sounds.at(0).maxRate, 4.0f);
    EXPECT_EQ(r->sceneTypes.at(0).ambientSound, 9u);
    EXPECT_EQ(r->sceneTypes[0].scenes, (std::vector<std::uint32_t>{0x12000001, 0x12000002}));
    EXPECT_EQ(r->misc.gameMap, 0x0600127Du);
    EXPECT_EQ(r->misc.clearMonster, 0x01001612u);
    EXPECT_EQ(*encode(*r), bytes);
}

TEST(RegionCodec, refusesStringPaddingThatIsNotZero) {
    std::string text = kHead + "00 00 00 00" + kTail;
    text.replace(text.find("2E 59 2E 00 00"), 14, "2E 59 2E 01 00");
    const auto r = decode<Region>(kRegionId, hex(text));
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().what, "the padding up to a multiple of four is not zero");
}

TEST(RegionCodec, longStringsHaveALongLengthAndOnlyThey) {
    Region r;
    r.id = kRegionId;
    for (const std::size_t length : {0xFFFEu, 0xFFFFu, 0x10001u}) {
        r.name.assign(length, 'x');
        const Bytes bytes = *encode(r);
        EXPECT_EQ(std::to_integer<int>(bytes[12]), length == 0xFFFE ? 0xFE : 0xFF);
        const auto again = decode<Region>(kRegionId, bytes);
        ASSERT_TRUE(again) << again.error().message();
        EXPECT_EQ(again->name, r.name);
    }
    const auto wasteful =
        decode<Region>(kRegionId, hex("00 00 00 13  01 00 00 00  03 00 00 00  FF FF 02 00 00 00 41 42"));
    ASSERT_FALSE(wasteful);
    EXPECT_EQ(wasteful.error().what, "the length of a string takes more bytes than it needs");
}

TEST(RegionCodec, refusesPaletteShiftedLand) {
    std::string text = kHead + "00 00 00 00" + kTail;
    const auto at =
        text.find("00 00 00 00                                                               # texture");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 2, "01");
    const auto r = decode<Region>(kRegionId, hex(text));
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().code, ErrorCode::Unsupported);
}

TEST(SceneCodec, anObjectTakes76Bytes) {
    const Bytes bytes = hex(R"(
        05 00 00 12  01 00 00 00
        01 00 00 02  00 00 80 3F 00 00 00 40 00 00 40 40  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00
        00 00 00 3F  00 00 A0 40  00 00 C0 40  00 00 80 3F  00 00 00 40  00 00 B4 43   # .5, 5, 6, 1..2, 360
        00 00 80 3E  00 00 80 3F  01 00 00 00  FF FF FF FF  78 56 34 12                # slopes, align, orient, weenie
    )");
    ASSERT_EQ(bytes.size(), 8u + 76u);
    const auto s = decode<Scene>(0x12000005, bytes);
    ASSERT_TRUE(s) << s.error().message();
    const SceneObject& o = s->objects.at(0);
    EXPECT_EQ(o.object, 0x02000001u);
    EXPECT_EQ(o.baseLoc.origin.z, 3.0f);
    EXPECT_EQ(o.frequency, 0.5f);
    EXPECT_EQ(o.displaceY, 6.0f);
    EXPECT_EQ(o.maxScale, 2.0f);
    EXPECT_EQ(o.maxRotation, 360.0f);
    EXPECT_EQ(o.minSlope, 0.25f);
    EXPECT_EQ(o.align, 1);
    EXPECT_EQ(o.orient, -1);
    EXPECT_EQ(o.weenieObj, 0x12345678u);
    EXPECT_EQ(*encode(*s), bytes);
}

} // namespace
} // namespace limen::dat
