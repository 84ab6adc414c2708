#pragma once

#include "world/Particles.h"
#include "world/records/Records.h"

#include <unordered_map>

// Particle emitters that scripts and animation hooks start: PhysicsScript (0x33), PhysicsScriptTable (0x34)
// and the hooks of Animation (0x03) records. Hooks for sounds, lights and other effects are ignored.
// docs/formats/effects_anim.md#hooks.
namespace limen::world {

/// One start of a particle emitter.
struct EmitterStart {
    dat::RecordId emitter = 0;   ///< ParticleEmitter (0x32) id
    std::uint32_t part = kNone;  ///< part of the Setup that carries it; kNone: the whole object
    Vec3 offset{0.0};            ///< in the part's frame, metres
    std::uint32_t name = 0;      ///< by which other hooks refer to it; 0: none does
    double at = 0.0;             ///< seconds from the start of the script or of the cycle
    double period = 0.0;         ///< mean seconds between repeated starts; 0: it starts once
    double jitter = 0.0;         ///< seconds: each repeated start is later by a random share of this
    double stop = kNeverEnds;    ///< seconds after `at` when births end
    double gone = kNeverEnds;    ///< seconds after `at` when its remaining particles are removed
    std::uint32_t cycle = kNone; ///< World::cycles: its times are that cycle's own; kNone: the world's
};

/// Follows scripts from hook to hook. A missing or damaged script is reported in the records' findings. The pause
/// of a call is random, uniform in 0..pause, and follows from `seed`.
class EmitterStarts {
public:
    explicit EmitterStarts(Records& records) : records_(records) {}

    /// The starts of a Setup's default script. A script that calls itself, directly or through others,
    /// repeats without end.
    [[nodiscard]] std::vector<EmitterStart> ofDefaultScript(const dat::Setup& setup, std::uint64_t seed);
    /// The starts of one script on an object of a Setup.
    [[nodiscard]] std::vector<EmitterStart> ofScript(dat::RecordId script, const dat::Setup& setup,
                                                     std::uint64_t seed);
    /// The starts of one hook on an object of a Setup; `at` counts from the hook.
    [[nodiscard]] std::vector<EmitterStart> ofHook(const dat::AnimationHook& hook, const dat::Setup& setup,
                                                   std::uint64_t seed);

private:
    struct Running {
        dat::RecordId script = 0;
        double start = 0.0;    ///< seconds
        std::size_t first = 0; ///< index of its first start in started_
        double period = 0.0;   ///< mean seconds; 0 until it calls itself
        double jitter = 0.0;   ///< seconds
    };
    /// `pause`: the longest pause before it runs.
    void run(dat::RecordId script, double at, double pause);
    [[nodiscard]] double drawnPause(double longest);
    void begin(const dat::Setup& setup, std::uint64_t seed);
    void play(const dat::AnimationHook& hook, double at);
    void create(const dat::AnimationHook& hook, double at, bool unlessThere);
    void finish(std::uint32_t name, double at, bool vanish);
    void repeat(const Running& running);

    Records& records_;
    const dat::Setup* setup_ = nullptr;
    std::vector<EmitterStart> started_;
    std::vector<Running> running_; ///< the call stack, outermost first
    std::uint64_t seed_ = 0;
    std::int64_t draws_ = 0; ///< random numbers drawn by the current call
    std::size_t runs_ = 0;   ///< scripts run by the current call of a public function
};

/// The script for one kind of play at an intensity: the first whose greatest intensity is not exceeded; 0 if
/// there is none.
[[nodiscard]] dat::RecordId chooseScript(const dat::PhysicsScriptTable& table, std::uint32_t kind,
                                         float intensity);

} // namespace limen::world
