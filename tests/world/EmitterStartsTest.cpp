#include "world/records/EmitterStarts.h"

#include "support/Effects.h"

#include <gtest/gtest.h>

namespace limen::world {
namespace {

using test::EffectsHut;

/// Runs a Setup's default script; the emitters need not exist.
std::vector<EmitterStart> run(EffectsHut& effects, std::uint32_t script, std::string* findings = nullptr,
                              std::uint64_t seed = 1) {
    const test::TempDir directory;
    EXPECT_TRUE(effects.hut.source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Records records(*archive);
    dat::Setup setup;
    setup.script = script;
    const std::vector<EmitterStart> starts = EmitterStarts(records).ofDefaultScript(setup, seed);
    for (const Finding& finding : records.findings())
        if (findings != nullptr)
            *findings += finding.what + "\n";
        else
            ADD_FAILURE() << finding.what;
    return starts;
}

TEST(EmitterStarts, haveTimePartAndPlaceOfTheirHooks) {
    EffectsHut effects;
    const std::uint32_t script = effects.addScript({{0.0, EffectsHut::create(0x32000001, 1, {1, 2, 3}, 9)},
                                                    {1.5, EffectsHut::hook(0x01, {5})}, // a sound
                                                    {2.5, EffectsHut::create(0x32000002)}});
    const std::vector<EmitterStart> starts = run(effects, script);
    ASSERT_EQ(starts.size(), 2u);
    EXPECT_EQ(starts[0].emitter, 0x32000001u);
    EXPECT_EQ(starts[0].part, 1u);
    EXPECT_EQ(starts[0].offset, Vec3(1, 2, 3));
    EXPECT_EQ(starts[0].name, 9u);
    EXPECT_EQ(starts[0].at, 0.0);
    EXPECT_EQ(starts[0].period, 0.0);
    EXPECT_EQ(starts[1].part, kNone);
    EXPECT_EQ(starts[1].at, 2.5);
    EXPECT_EQ(starts[1].gone, kNeverEnds);
}

TEST(EmitterStarts, followCalledScripts) {
    EffectsHut effects;
    const std::uint32_t inner = effects.addScript({{0.5, EffectsHut::create(0x32000001)}});
    const std::uint32_t outer = effects.addScript({{1.0, EffectsHut::call(inner, 0.0f)}});
    const std::vector<EmitterStart> starts = run(effects, outer);
    ASSERT_EQ(starts.size(), 1u);
    EXPECT_EQ(starts[0].at, 1.5);
    EXPECT_EQ(starts[0].period, 0.0);
}

TEST(EmitterStarts, waitForARandomPartOfThePauseOfACall) {
    EffectsHut effects;
    const std::uint32_t inner = effects.addScript({{0.5, EffectsHut::create(0x32000001)}});
    const std::uint32_t outer = effects.addScript({{1.0, EffectsHut::call(inner, 4.0f)}});
    double least = 1e9, most = 0.0, sum = 0.0;
    constexpr int kSeeds = 200;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const double at = run(effects, outer, nullptr, static_cast<std::uint64_t>(seed)).at(0).at;
        least = std::min(least, at);
        most = std::max(most, at);
        sum += at;
    }
    EXPECT_GE(least, 1.5);
    EXPECT_LT(least, 1.7);
    EXPECT_LT(most, 5.5);
    EXPECT_GT(most, 5.3);
    EXPECT_NEAR(sum / kSeeds, 3.5, 0.3) << "uniform";
    EXPECT_EQ(run(effects, outer).at(0).at, run(effects, outer).at(0).at) << "the same for the same seed";
}

TEST(EmitterStarts, doNotWaitForAPauseOfNextToNothing) {
    EffectsHut effects;
    const std::uint32_t inner = effects.addScript({{0.5, EffectsHut::create(0x32000001)}});
    const std::uint32_t outer = effects.addScript({{1.0, EffectsHut::call(inner, 0.00019f)}});
    EXPECT_EQ(run(effects, outer).at(0).at, 1.5);
}

TEST(EmitterStarts, goRoundWithAScriptThatCallsItself) {
    EffectsHut effects;
    const std::uint32_t self = effects.nextScript();
    const std::uint32_t script = effects.addScript({{0.25, EffectsHut::create(0x32000001)},
                                                    {2.0, EffectsHut::call(self, 1.0f)},
                                                    {2.5, EffectsHut::create(0x32000002)}});
    const std::vector<EmitterStart> starts = run(effects, script);
    ASSERT_EQ(starts.size(), 2u);
    for (const EmitterStart& start : starts)
        EXPECT_EQ(start.period, 2.5) << "half the pause in the mean";
    for (const EmitterStart& start : starts)
        EXPECT_EQ(start.jitter, 0.5);
    EXPECT_EQ(starts[0].at, 0.25);
    EXPECT_EQ(starts[1].at, 2.5);
}

TEST(EmitterStarts, repeatOnlyTheStartsWithinTheLoop) {
    EffectsHut effects;
    const std::uint32_t self = effects.nextScript();
    const std::uint32_t loop =
        effects.addScript({{0.0, EffectsHut::create(0x32000001)}, {2.0, EffectsHut::call(self, 0.0f)}});
    const std::uint32_t script =
        effects.addScript({{0.0, EffectsHut::create(0x32000002)}, {5.0, EffectsHut::call(loop, 0.0f)}});
    const std::vector<EmitterStart> starts = run(effects, script);
    ASSERT_EQ(starts.size(), 2u);
    EXPECT_EQ(starts[0].period, 0.0);
    EXPECT_EQ(starts[1].period, 2.0);
    EXPECT_EQ(starts[1].at, 5.0);
}

TEST(EmitterStarts, aRoundWithoutAPauseIsAFrame) {
    EffectsHut effects;
    const std::uint32_t self = effects.nextScript();
    const std::uint32_t script =
        effects.addScript({{0.0, EffectsHut::create(0x32000001)}, {0.0, EffectsHut::call(self, 0.0f)}});
    EXPECT_NEAR(run(effects, script).at(0).period, 1.0 / 30.0, 1e-9);
}

TEST(EmitterStarts, endByTheirNames) {
    EffectsHut effects;
    const std::uint32_t script = effects.addScript({{1.0, EffectsHut::create(0x32000001, 0, {}, 7)},
                                                    {1.0, EffectsHut::create(0x32000002, 0, {}, 8)},
                                                    {1.0, EffectsHut::create(0x32000003, 0, {}, 0)},
                                                    {3.0, EffectsHut::stop(7)},
                                                    {4.0, EffectsHut::destroy(8)},
                                                    {4.0, EffectsHut::destroy(0)}});
    const std::vector<EmitterStart> starts = run(effects, script);
    ASSERT_EQ(starts.size(), 3u);
    EXPECT_EQ(starts[0].stop, 2.0);
    EXPECT_EQ(starts[0].gone, kNeverEnds);
    EXPECT_EQ(starts[1].gone, 3.0);
    EXPECT_EQ(starts[2].gone, kNeverEnds) << "no hook can refer to an emitter without a name";
}

TEST(EmitterStarts, oneTakesThePlaceOfAnotherOfItsName) {
    EffectsHut effects;
    const auto blocking =
        EffectsHut::hook(0x1A, {0x32000004, 0, 0, 0, 0, EffectsHut::word(1.0f), 0, 0, 0, 7});
    const std::uint32_t script = effects.addScript(
        {{0.0, EffectsHut::create(0x32000001, 0, {}, 7)}, {2.0, EffectsHut::create(0x32000002, 0, {}, 7)}});
    const std::vector<EmitterStart> starts = run(effects, script);
    ASSERT_EQ(starts.size(), 2u);
    EXPECT_EQ(starts[0].gone, 2.0);
    EXPECT_EQ(starts[1].gone, kNeverEnds);
    EffectsHut more;
    const std::uint32_t blocked =
        more.addScript({{0.0, EffectsHut::create(0x32000001, 0, {}, 7)}, {2.0, blocking}});
    ASSERT_EQ(run(more, blocked).size(), 1u) << "blocked by the emitter of that name";
    EXPECT_EQ(run(more, blocked)[0].gone, kNeverEnds);
}

TEST(EmitterStarts, endlessCallsOfScriptsAreReportedAndCutOff) {
    EffectsHut effects;
    // Each script calls the next one four times: a million calls without a limit.
    const std::uint32_t first = effects.nextScript();
    for (std::uint32_t i = 0; i < 10; ++i) {
        std::vector<dat::ScriptedHook> hooks(4, {1.0, EffectsHut::call(first + i + 1, 0.0f)});
        hooks.push_back({0.0, EffectsHut::create(0x32000001)});
        effects.addScript(hooks);
    }
    effects.addScript({{0.0, EffectsHut::create(0x32000001)}});
    std::string findings;
    EXPECT_LE(run(effects, first, &findings).size(), 256u);
    EXPECT_EQ(findings, "scripts call each other too often: it is not run\n");
}

TEST(EmitterStarts, aMissingScriptIsReported) {
    EffectsHut effects;
    std::string findings;
    EXPECT_TRUE(run(effects, 0x33000123, &findings).empty());
    EXPECT_FALSE(findings.empty());
}

TEST(ChooseScript, takesTheFirstThatIsStrongEnough) {
    dat::PhysicsScriptTable table;
    table.scripts = {{4, {{0.25f, 0x33000001}, {0.5f, 0x33000002}, {1.0f, 0x33000003}}}, {5, {}}};
    EXPECT_EQ(chooseScript(table, 4, 0.0f), 0x33000001u);
    EXPECT_EQ(chooseScript(table, 4, 0.25f), 0x33000001u);
    EXPECT_EQ(chooseScript(table, 4, 0.3f), 0x33000002u);
    EXPECT_EQ(chooseScript(table, 4, 2.0f), 0u);
    EXPECT_EQ(chooseScript(table, 5, 0.0f), 0u);
    EXPECT_EQ(chooseScript(table, 6, 0.0f), 0u);
}

} // namespace
} // namespace limen::world
