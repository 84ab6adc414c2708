#include "dat/Describe.h"
#include "dat/Hex.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

// Bytes by hand, after docs/formats/effects_anim.md.
namespace limen::dat {
namespace {

TEST(AnimationCodec, readsTheLeastThereCanBe) {
    const Bytes bytes = hex("07 00 00 03  00 00 00 00  00 00 00 00  00 00 00 00");
    const auto a = decode<Animation>(0x03000007, bytes);
    ASSERT_TRUE(a) << a.error().message();
    EXPECT_EQ(a->partCount, 0u);
    EXPECT_TRUE(a->frames.empty());
    EXPECT_EQ(*encode(*a), bytes);
}

TEST(AnimationCodec, readsPositionsPartsAndHooks) {
    const Bytes bytes = hex(R"(
        07 00 00 03  01 00 00 00  01 00 00 00  02 00 00 00               # id, positions, one part, two frames
        00 00 80 3F 00 00 00 00 00 00 00 00  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00   # 1 m to the east
        00 00 00 40 00 00 00 00 00 00 00 00  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00   # 2 m
        00 00 00 00 00 00 00 00 00 00 00 3F  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00   # part, 0.5 m up
        02 00 00 00                                                      # two hooks:
        0F 00 00 00  01 00 00 00  09 00 00 00                            # stop emitter 9, forwards
        05 00 00 00  FF FF FF FF  02 01 80 78 56 CD CD CD                # part 2 becomes 01000000 + 15678, backwards
        00 00 00 00 00 00 00 00 00 00 00 00  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00
        00 00 00 00
    )");
    const auto a = decode<Animation>(0x03000007, bytes);
    ASSERT_TRUE(a) << a.error().message();
    ASSERT_EQ(a->positionFrames.size(), 2u);
    EXPECT_EQ(a->positionFrames[1].origin.x, 2.0f);
    ASSERT_EQ(a->frames.size(), 2u);
    EXPECT_EQ(a->frames[0].parts.at(0).origin.z, 0.5f);
    ASSERT_EQ(a->frames[0].hooks.size(), 2u);
    EXPECT_EQ(a->frames[0].hooks[0].type, 0x0Fu);
    EXPECT_EQ(a->frames[0].hooks[1].direction, -1);
    EXPECT_EQ(a->frames[0].hooks[1].payload.size(), 8u);
    EXPECT_TRUE(a->frames[1].hooks.empty());
    EXPECT_EQ(*encode(*a), bytes);
}

TEST(AnimationCodec, refusesMoreFramesThanThereAreBytesFor) {
    const auto a = decode<Animation>(0x03000007, hex("07 00 00 03  00 00 00 00  00 00 00 00  FF FF FF 7F"));
    ASSERT_FALSE(a);
    EXPECT_NE(a.error().what.find("frames"), std::string::npos) << a.error().message();
}

TEST(AnimationCodec, triesABlockingParticleBothWays) {
    const std::string start =
        "07 00 00 03  00 00 00 00  00 00 00 00  01 00 00 00  01 00 00 00  1A 00 00 00  00 00 00 00 ";
    const std::string payload(3 * 40, '0'); // 40 bytes of zeros, as text
    for (const std::string& text : {start, start + payload.substr(0, 80)}) {
        const Bytes bytes = hex(text);
        const auto a = decode<Animation>(0x03000007, bytes);
        ASSERT_TRUE(a) << a.error().message();
        EXPECT_EQ(*encode(*a), bytes);
    }
}

TEST(MotionTableCodec, readsTheLeastThereCanBe) {
    const Bytes bytes = hex("01 00 00 09  3D 00 00 80  00 00 00 00  00 00 00 00  00 00 00 00  00 00 00 00");
    const auto t = decode<MotionTable>(0x09000001, bytes);
    ASSERT_TRUE(t) << t.error().message();
    EXPECT_EQ(t->defaultStyle, 0x8000003Du);
    EXPECT_EQ(*encode(*t), bytes);
}

TEST(MotionTableCodec, readsCyclesModifiersAndLinks) {
    const Bytes bytes = hex(R"(
        01 00 00 09  3D 00 00 80                                  # id, default style
        01 00 00 00  3D 00 00 80  03 00 00 41                     # of that style: ready
        01 00 00 00  03 00 3D 00                                  # cycles: one
        02 01 03 7F                                               # two animations, clears modifiers, velocity and omega; padding
        05 00 00 03  00 00 00 00  FF FF FF FF  00 00 F0 41        # all of 03000005 at 30
        06 00 00 03  04 00 00 00  02 00 00 00  00 00 70 C1        # 4 to 2 at -15
        00 00 00 00 00 00 80 40 00 00 00 00                       # 4 m/s north
        00 00 00 00 00 00 00 00 00 00 80 3F                       # 1 rad/s
        00 00 00 00                                               # modifiers: none
        01 00 00 00  03 00 3D 00                                  # links from there: one
        01 00 00 00  07 00 00 45  00 02 00 00                     # to 45000007: nothing, only from the default
    )");
    const auto t = decode<MotionTable>(0x09000001, bytes);
    ASSERT_TRUE(t) << t.error().message();
    ASSERT_EQ(t->styleDefaults.size(), 1u);
    EXPECT_EQ(t->styleDefaults[0].second, 0x41000003u);
    ASSERT_EQ(t->cycles.size(), 1u);
    EXPECT_EQ(t->cycles[0].first, motionKey(0x8000003D, 0x41000003));
    const MotionData& walk = t->cycles[0].second;
    EXPECT_EQ(walk.bitfield, MotionData::kClearsModifiers);
    ASSERT_EQ(walk.animations.size(), 2u);
    EXPECT_EQ(walk.animations[0].high, -1);
    EXPECT_EQ(walk.animations[1].fps, -15.0f);
    EXPECT_EQ(walk.velocity.y, 4.0f);
    EXPECT_EQ(walk.omega.z, 1.0f);
    ASSERT_EQ(t->links.size(), 1u);
    EXPECT_EQ(t->links[0].second.at(0).first, 0x45000007u);
    EXPECT_EQ(t->links[0].second[0].second.bitfield, MotionData::kOnlyFromDefault);
    EXPECT_EQ(*encode(*t), bytes) << "with the bytes of the padding";
    const auto json = nlohmann::json::parse(describe(*t));
    EXPECT_EQ(json["cycles"][0]["animations"][0]["animation"], "0x03000005");
    EXPECT_EQ(json["links"][0]["to"][0]["key"], "0x45000007");
}

TEST(MotionKey, dropsWhatDoesNotFit) {
    EXPECT_EQ(motionKey(0x8000003D, 0x41000003), 0x003D0003u);
    EXPECT_EQ(motionKey(0x8000003D, 0x00FF0003), 0x00FF0003u | 0x003D0000u);
}

} // namespace
} // namespace limen::dat
