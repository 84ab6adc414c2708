#include "doctor/retail/Hooks.h"
#include "doctor/retail/Judges.h"

#include <algorithm>

namespace limen::doctor {
namespace {

constexpr const char* kScripts = "published notes on the sky's scripts";
using EffectNumbers = std::optional<Numbers>;

Numbers emittersOf(const dat::PhysicsScript& script) {
    Numbers emitters;
    for (const dat::ScriptedHook& hook : script.hooks)
        if (const std::optional<std::uint32_t> emitter = emitterOf(hook.hook))
            emitters.push_back(*emitter);
    return emitters;
}

/// The first call of a script.
std::optional<ScriptCall> callOf(const dat::PhysicsScript& script) {
    for (const dat::ScriptedHook& hook : script.hooks)
        if (const std::optional<ScriptCall> call = scriptCallOf(hook.hook))
            return call;
    return std::nullopt;
}

EffectNumbers wavePlayedBy(const dat::PhysicsScript& script) {
    for (const dat::ScriptedHook& hook : script.hooks)
        if (const std::optional<WavePlayed> played = waveOf(hook.hook))
            return Numbers{static_cast<double>(played->wave), played->volume};
    return std::nullopt;
}

} // namespace

void judgeEffects(const dat::Archive& archive, Ledger& ledger) {
    const auto clouds = archive.load<dat::PhysicsScript>(0x330007DB);
    ledger.judgeRecord(clouds,
                       Fact{"effect.330007DB.emitters", kScripts, {0x32000455, 0x32000456, 0x32000457}}.hex(),
                       [](const dat::PhysicsScript& s) { return EffectNumbers(emittersOf(s)); });
    ledger.judgeRecord(clouds, Fact{"effect.330007DB.times", kScripts, {0, 0, 0}},
                       [](const dat::PhysicsScript& s) {
                           Numbers times;
                           for (const dat::ScriptedHook& hook : s.hooks)
                               if (emitterOf(hook.hook))
                                   times.push_back(hook.startTime);
                           return EffectNumbers(times);
                       });
    for (const dat::RecordId id : {0x33000428u, 0x33000429u})
        ledger.judgeRecord(archive.load<dat::PhysicsScript>(id),
                           Fact{id == 0x33000428u ? "effect.33000428.wave" : "effect.33000429.wave",
                                kScripts,
                                {0x0A00038B, 0.35}}
                               .within(0.001),
                           wavePlayedBy);
    const auto thunder = archive.load<dat::PhysicsScript>(0x33000453);
    ledger.judgeRecord(thunder, Fact{"effect.33000453.callsItself", kScripts, {0x33000453}}.hex(),
                       [](const dat::PhysicsScript& s) -> EffectNumbers {
                           const std::optional<ScriptCall> call = callOf(s);
                           if (!call)
                               return std::nullopt;
                           return Numbers{static_cast<double>(call->script)};
                       });
    ledger.judgeRecord(thunder, Fact{"effect.33000453.pause", kScripts, {30}}.within(0.001),
                       [](const dat::PhysicsScript& s) -> EffectNumbers {
                           const std::optional<ScriptCall> call = callOf(s);
                           if (!call)
                               return std::nullopt;
                           return Numbers{call->pause};
                       });
    ledger.judgeRecord(
        thunder, Fact{"effect.33000453.emitter", kScripts, {1}}, [](const dat::PhysicsScript& s) {
            const Numbers emitters = emittersOf(s);
            return someNumbers(
                {std::find(emitters.begin(), emitters.end(), double{0x320002C2}) != emitters.end() ? 1.0
                                                                                                   : 0.0});
        });
    ledger.judgeRecord(
        archive.load<dat::Setup>(0x02000714), Fact{"effect.02000714.script", kScripts, {0x330007DB}}.hex(),
        [](const dat::Setup& setup) { return someNumbers({static_cast<double>(setup.script)}); });
}

} // namespace limen::doctor
