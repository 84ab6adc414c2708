#include "world/records/EmitterStarts.h"

#include "core/Assert.h"
#include "world/HashedUnit.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace limen::world {
namespace {

// Hook types. docs/formats/effects_anim.md#hooks.
constexpr std::uint32_t kCreate = 0x0D, kDestroy = 0x0E, kStop = 0x0F, kDefaultScript = 0x11,
                        kDefaultScriptPart = 0x12, kCallScript = 0x13, kCreateBlocking = 0x1A;

// Seconds. Without a least period, a script that calls itself without a delay would start infinitely often at
// one time.
constexpr double kLeastPeriod = 1.0 / 30.0;
constexpr double kLeastPause = 0.0002; // shorter ones do not count
// Limits beyond the needs of every intact script. More means damaged data.
constexpr std::size_t kDeepest = 16, kMostStarts = 256, kMostRuns = 1024;

template <class Word>
Word wordAt(const dat::AnimationHook& hook, std::size_t offset) {
    Word word{};
    if (offset + sizeof word <= hook.payload.size())
        std::memcpy(&word, hook.payload.data() + offset, sizeof word);
    return word;
}

/// Seconds, clamped. A time that is negative or not a number becomes 0.
double timeOf(double seconds) {
    constexpr double kLongest = 1e6;
    return seconds > 0.0 ? std::min(seconds, kLongest) : 0.0;
}

} // namespace

std::vector<EmitterStart> EmitterStarts::ofDefaultScript(const dat::Setup& setup, std::uint64_t seed) {
    return setup.script != 0 ? ofScript(setup.script, setup, seed) : std::vector<EmitterStart>();
}

void EmitterStarts::begin(const dat::Setup& setup, std::uint64_t seed) {
    LIMEN_ASSERT(running_.empty() && started_.empty(), "no call is under way");
    setup_ = &setup;
    seed_ = seed;
    draws_ = 0;
    runs_ = 0;
}

std::vector<EmitterStart> EmitterStarts::ofScript(dat::RecordId script, const dat::Setup& setup,
                                                  std::uint64_t seed) {
    begin(setup, seed);
    run(script, 0.0, 0.0);
    return std::exchange(started_, {});
}

std::vector<EmitterStart> EmitterStarts::ofHook(const dat::AnimationHook& hook, const dat::Setup& setup,
                                                std::uint64_t seed) {
    begin(setup, seed);
    play(hook, 0.0);
    return std::exchange(started_, {});
}

double EmitterStarts::drawnPause(double longest) {
    return longest >= kLeastPause ? longest * hashedUnit(seed_, draws_++, 0) : 0.0;
}

void EmitterStarts::run(dat::RecordId script, double at, double pause) {
    const auto again =
        std::find_if(running_.begin(), running_.end(), [&](const Running& r) { return r.script == script; });
    if (again != running_.end()) {
        // Repetitions are half the pause apart in the mean. Each comes later by up to half the pause: the
        // intervals are 0 to `pause` longer than the script.
        if (again->period == 0.0) {
            again->period = std::max(at + pause / 2.0 - again->start, kLeastPeriod);
            again->jitter = pause / 2.0;
        }
        return;
    }
    at += drawnPause(pause);
    const dat::PhysicsScript* record = records_.physicsScript(script);
    if (record == nullptr)
        return;
    if (running_.size() == kDeepest || ++runs_ > kMostRuns) {
        if (runs_ <= kMostRuns + 1) // later calls would repeat the finding
            records_.report({script, "scripts call each other too often: it is not run"});
        return;
    }
    running_.push_back({script, at, started_.size(), 0.0, 0.0});
    for (const dat::ScriptedHook& hook : record->hooks)
        play(hook.hook, at + timeOf(hook.startTime));
    repeat(running_.back());
    running_.pop_back();
}

void EmitterStarts::repeat(const Running& running) {
    if (running.period == 0.0)
        return;
    for (std::size_t i = running.first; i < started_.size(); ++i) {
        EmitterStart& start = started_[i];
        if (start.period != 0.0)
            continue; // an inner script that repeats by itself keeps its own period
        start.period = running.period;
        start.jitter = running.jitter;
    }
}

void EmitterStarts::play(const dat::AnimationHook& hook, double at) {
    switch (hook.type) {
    case kCreate:
        create(hook, at, false);
        return;
    case kCreateBlocking:
        if (!hook.payload.empty())
            create(hook, at, true);
        return;
    case kDestroy:
    case kStop:
        finish(wordAt<std::uint32_t>(hook, 0), at, hook.type == kDestroy);
        return;
    case kDefaultScript:
    case kDefaultScriptPart:
        if (setup_->script != 0)
            run(setup_->script, at, 0.0);
        return;
    case kCallScript:
        run(wordAt<std::uint32_t>(hook, 0), at, timeOf(static_cast<double>(wordAt<float>(hook, 4))));
        return;
    default:
        return;
    }
}

void EmitterStarts::create(const dat::AnimationHook& hook, double at, bool unlessThere) {
    EmitterStart start;
    start.emitter = wordAt<std::uint32_t>(hook, 0);
    start.part = wordAt<std::uint32_t>(hook, 4);
    const Vec3 offset(wordAt<float>(hook, 8), wordAt<float>(hook, 12), wordAt<float>(hook, 16));
    start.offset = isFinite(offset) ? offset : Vec3(0.0);
    start.name = wordAt<std::uint32_t>(hook, 36); // after the offset's quaternion
    start.at = at;
    const bool isThere = std::any_of(started_.begin(), started_.end(), [&](const EmitterStart& s) {
        return s.name == start.name && s.gone == kNeverEnds;
    });
    if (start.name != 0 && isThere) {
        if (unlessThere)
            return;
        finish(start.name, at, true);
    }
    if (started_.size() < kMostStarts)
        started_.push_back(start);
}

void EmitterStarts::finish(std::uint32_t name, double at, bool vanish) {
    for (EmitterStart& start : started_) {
        if (name == 0 || start.name != name)
            continue;
        const double after = std::max(at - start.at, 0.0);
        start.stop = std::min(start.stop, after);
        if (vanish)
            start.gone = std::min(start.gone, after);
    }
}

dat::RecordId chooseScript(const dat::PhysicsScriptTable& table, std::uint32_t kind, float intensity) {
    const auto found = std::find_if(table.scripts.begin(), table.scripts.end(),
                                    [kind](const auto& entry) { return entry.first == kind; });
    if (found == table.scripts.end())
        return 0;
    const auto choice = std::find_if(found->second.begin(), found->second.end(),
                                     [intensity](const dat::ScriptChoice& c) { return c.most >= intensity; });
    return choice != found->second.end() ? choice->script : 0;
}

} // namespace limen::world
