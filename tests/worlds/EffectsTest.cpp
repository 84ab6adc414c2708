#include "motion/DynamicStateBuilder.h"
#include "worlds/BuiltIn.h"
#include "worlds/Loaded.h"

#include <gtest/gtest.h>
#include <set>
#include <tuple>

// All effects of the built-in world load and are played.
namespace limen::worlds::test {
namespace {

template <class Records>
bool has(const Records& records, std::uint32_t id) {
    return std::any_of(records.begin(), records.end(), [id](const auto& r) { return r.id == id; });
}

std::uint32_t wordOf(const dat::AnimationHook& hook) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word |= std::uint32_t{hook.payload.at(k)} << (8 * k);
    return word;
}

TEST(Effects, nameRecordsThatAreThere) {
    for (const dat::ParticleEmitter& emitter : world().particleEmitters)
        EXPECT_TRUE(has(world().gfxObjs, emitter.gfxObj));
    std::size_t hooks = 0;
    for (const dat::PhysicsScript& script : world().physicsScripts) {
        for (const dat::ScriptedHook& hook : script.hooks) {
            ++hooks;
            EXPECT_TRUE(hook.hook.type == 0x13 ? has(world().physicsScripts, wordOf(hook.hook))
                                               : has(world().particleEmitters, wordOf(hook.hook)));
        }
    }
    EXPECT_GT(hooks, 10u);
    for (const dat::PhysicsScriptTable& table : world().physicsScriptTables) {
        for (const auto& [kind, choices] : table.scripts)
            for (const dat::ScriptChoice& choice : choices)
                EXPECT_TRUE(has(world().physicsScripts, choice.script));
    }
    for (const dat::Setup& setup : world().setups) {
        EXPECT_TRUE(setup.script == 0 || has(world().physicsScripts, setup.script));
        EXPECT_TRUE(setup.scriptTable == 0 || has(world().physicsScriptTables, setup.scriptTable));
        EXPECT_TRUE(setup.animation == 0 || has(world().animations, setup.animation));
    }
    for (const dat::GfxObj& object : world().gfxObjs)
        EXPECT_TRUE(object.degradeId == 0 || has(world().degradeInfos, object.degradeId));
    for (const dat::PaletteSet& set : world().paletteSets)
        for (const std::uint32_t palette : set.palettes)
            EXPECT_TRUE(has(world().palettes, palette));
    EXPECT_FALSE(world().clothingTables.empty());
}

struct Before {
    bool operator()(const Vec3& a, const Vec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

TEST(Effects, areAllPlayed) {
    std::set<dat::ParticleType> types;
    for (const world::ParticleStyle& style : loaded().particleStyles)
        types.insert(style.type);
    EXPECT_GE(types.size(), 8u) << "most ways of moving";
    EXPECT_EQ(loaded().idleObjects.size(), 2u) << "the whirligig and the vane";
    motion::DynamicStateBuilder dynamicsBuilder(loaded());
    world::DynamicState dynamics;
    std::set<Vec3, Before> eyes; // particles are drawn near the eye alone
    for (const world::ParticleSource& source : loaded().particleSources)
        if (source.villager == world::kNone)
            eyes.insert(source.idle == world::kNone ? source.at.origin
                                                    : loaded().idleObjects[source.idle].origin);
    for (const world::RoutePoint& point : loaded().routePoints)
        eyes.insert(point.position);
    std::set<std::uint64_t> objects; // visible at any time
    for (double seconds = 10.0; seconds < 24.0; seconds += 0.21) {
        motion::DynamicStateInput input;
        input.seconds = seconds;
        input.weather = world::SkyHour{1, 0.5}; // snow
        for (const Vec3& eye : eyes) {
            input.eye = eye;
            dynamicsBuilder.build(input, dynamics);
            for (const world::Instance& instance : dynamics.instances)
                objects.insert(instance.object);
        }
    }
    for (const world::ParticleStyle& style : loaded().particleStyles)
        EXPECT_TRUE(objects.contains(loaded().movingParts[style.part].object))
            << std::hex << "particles of " << style.record;
}

} // namespace
} // namespace limen::worlds::test
