#include "dat/Describe.h"
#include "dat/Hex.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

// Bytes by hand, after docs/formats/effects_anim.md.
namespace limen::dat {
namespace {

const char* const kEmitter = R"(
    0A 00 00 32  00 00 00 00  01 00 00 00  03 00 00 00            # id, unknown, per second, ParabolicLVGA
    01 00 00 01  02 00 00 01                                      # software and hardware GfxObj
    00 00 00 00 00 00 D0 3F                                       # a particle every 0.25 s
    14 00 00 00  05 00 00 00  00 00 00 00                         # 20 at most, 5 at first, no end
    00 00 00 00 00 00 00 00                                       # no end in time
    00 00 00 00 00 00 00 40  00 00 00 00 00 00 E0 3F              # live 2 s, give or take 0.5
    00 00 00 00 00 00 00 00 00 00 80 3F  00 00 00 3F 00 00 40 3F  # aside of up, 0.5 to 0.75 m
    00 00 00 00 00 00 00 00 00 00 00 40  00 00 80 3F 00 00 80 3F  # A: 2 up
    00 00 00 00 00 00 00 00 00 00 1D C1  00 00 00 00 00 00 80 3F  # B: 9.8125 down, 0 to 1
    00 00 00 00 00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00  # C
    00 00 80 3F  00 00 00 40  00 00 80 3E                         # scale 1 to 2, random 0.25
    00 00 00 3F  00 00 80 3F  00 00 00 00                         # translucency 0.5 to 1
    01 00 00 00                                                   # follows its parent
)";

TEST(ParticleEmitterCodec, readsEveryFieldWhereItStands) {
    const Bytes bytes = hex(kEmitter);
    const auto e = decode<ParticleEmitter>(0x3200000A, bytes);
    ASSERT_TRUE(e) << e.error().message();
    EXPECT_EQ(e->emitterType, ParticleEmitter::kPerSecond);
    EXPECT_EQ(e->particleType, ParticleType::ParabolicLVGA);
    EXPECT_EQ(e->softwareGfxObj, 0x01000001u);
    EXPECT_EQ(e->gfxObj, 0x01000002u);
    EXPECT_EQ(e->birthrate, 0.25);
    EXPECT_EQ(e->maxParticles, 20);
    EXPECT_EQ(e->initialParticles, 5);
    EXPECT_EQ(e->totalParticles, 0);
    EXPECT_EQ(e->totalSeconds, 0.0);
    EXPECT_EQ(e->lifespan, 2.0);
    EXPECT_EQ(e->lifespanRandom, 0.5);
    EXPECT_EQ(e->offset.vector, Vec3f(0, 0, 1));
    EXPECT_EQ(e->offset.most, 0.75f);
    EXPECT_EQ(e->a.vector.z, 2.0f);
    EXPECT_EQ(e->b.vector.z, -9.8125f);
    EXPECT_EQ(e->b.least, 0.0f);
    EXPECT_EQ(e->c.most, 0.0f);
    EXPECT_EQ(e->scale.end, 2.0f);
    EXPECT_EQ(e->scale.random, 0.25f);
    EXPECT_EQ(e->translucency.start, 0.5f);
    EXPECT_EQ(e->isParentLocal, 1u);
    EXPECT_EQ(*encode(*e), bytes);
    const auto json = nlohmann::json::parse(describe(*e));
    EXPECT_EQ(json["particle_type"], 3);
    EXPECT_EQ(json["birthrate"], 0.25);
}

TEST(ParticleEmitterCodec, keepsTypesThatNobodyKnows) {
    Bytes bytes = hex(kEmitter);
    bytes[12] = std::byte{0x63};
    const auto e = decode<ParticleEmitter>(0x3200000A, bytes);
    ASSERT_TRUE(e) << e.error().message();
    EXPECT_EQ(static_cast<int>(e->particleType), 0x63);
    EXPECT_EQ(*encode(*e), bytes);
}

TEST(PhysicsScriptCodec, readsNoneAndSome) {
    const Bytes none = hex("01 00 00 33  00 00 00 00");
    const auto empty = decode<PhysicsScript>(0x33000001, none);
    ASSERT_TRUE(empty) << empty.error().message();
    EXPECT_EQ(*encode(*empty), none);
    const Bytes bytes = hex(R"(
        01 00 00 33  02 00 00 00
        00 00 00 00 00 00 00 00                                   # at once:
        0D 00 00 00  00 00 00 00  0A 00 00 32  FF FF FF FF        # emitter 3200000A at the object
        00 00 00 00 00 00 00 00 00 00 80 3F  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00
        07 00 00 00                                               # as number 7
        00 00 00 00 00 00 04 40                                   # after 2.5 s:
        13 00 00 00  00 00 00 00  01 00 00 33  00 00 80 3F        # this script again, pause 1 s
    )");
    const auto s = decode<PhysicsScript>(0x33000001, bytes);
    ASSERT_TRUE(s) << s.error().message();
    ASSERT_EQ(s->hooks.size(), 2u);
    EXPECT_EQ(s->hooks[0].hook.type, 0x0Du);
    EXPECT_EQ(s->hooks[0].hook.payload.size(), 40u);
    EXPECT_EQ(s->hooks[1].startTime, 2.5);
    EXPECT_EQ(*encode(*s), bytes);
    EXPECT_EQ(nlohmann::json::parse(describe(*s))["hooks"][1]["at"], 2.5);
}

TEST(PhysicsScriptCodec, refusesAHookThatNobodyKnows) {
    const auto s = decode<PhysicsScript>(
        0x33000001, hex("01 00 00 33  01 00 00 00  00 00 00 00 00 00 00 00  1B 00 00 00  00 00 00 00"));
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().what, "0x1B is not the type of an animation hook");
}

TEST(PhysicsScriptTableCodec, readsNoneAndSome) {
    const Bytes none = hex("01 00 00 34  00 00 00 00");
    const auto empty = decode<PhysicsScriptTable>(0x34000001, none);
    ASSERT_TRUE(empty) << empty.error().message();
    EXPECT_EQ(*encode(*empty), none);
    const Bytes bytes = hex(R"(
        01 00 00 34  02 00 00 00
        05 00 00 00  02 00 00 00  00 00 00 3F 01 00 00 33  00 00 80 3F 02 00 00 33   # up to 0.5, up to 1
        2A 00 00 00  00 00 00 00
    )");
    const auto t = decode<PhysicsScriptTable>(0x34000001, bytes);
    ASSERT_TRUE(t) << t.error().message();
    ASSERT_EQ(t->scripts.size(), 2u);
    EXPECT_EQ(t->scripts[0].second.at(1).script, 0x33000002u);
    EXPECT_EQ(t->scripts[0].second[0].most, 0.5f);
    EXPECT_TRUE(t->scripts[1].second.empty());
    EXPECT_EQ(*encode(*t), bytes);
    EXPECT_EQ(nlohmann::json::parse(describe(*t))["scripts"][0]["choices"][1]["script"], "0x33000002");
}

} // namespace
} // namespace limen::dat
