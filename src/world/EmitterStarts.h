#pragma once

#include "world/Particles.h"
#include "world/Records.h"

#include <unordered_map>

// What scripts and animation hooks start: PhysicsScript (0x33), PhysicsScriptTable (0x34), hooks of Animations (0x03), after
// docs/formats/effects_anim.md#hooks. Of all hooks only those count that have to do with particle emitters.
namespace limen::world {

/// A particle emitter that is started.
struct EmitterStart {
    dat::RecordId emitter = 0;   ///< ParticleEmitter (0x32) id
    std::uint32_t part = kNone;  ///< of the Setup; kNone: the whole object
    Vec3 offset{0.0};            ///< in the part's frame
    std::uint32_t name = 0;      ///< by which other hooks speak of it; 0: none does
    double at = 0.0;             ///< seconds from the beginning of the script, or of the cycle
    double period = 0.0;         ///< again every so many seconds; 0: once
    double stop = kNeverEnds;    ///< seconds after `at` when births end
    double gone = kNeverEnds;    ///< seconds after `at` when all that is left vanishes
    std::uint32_t cycle = kNone; ///< World::cycles: its times are that cycle's own; kNone: the world's
};

/// Follows scripts from hook to hook. A script that is missing or damaged is said in the records' findings.
class EmitterStarts {
public:
    explicit EmitterStarts(Records& records) : records_(records) {}

    /// What a Setup's default script starts. One that calls itself, by whatever way, goes round for ever.
    [[nodiscard]] std::vector<EmitterStart> ofDefaultScript(const dat::Setup& setup);
    /// What one script starts on an object of a Setup.
    [[nodiscard]] std::vector<EmitterStart> ofScript(dat::RecordId script, const dat::Setup& setup);
    /// What a hook starts at once, on an object of a Setup.
    [[nodiscard]] std::vector<EmitterStart> ofHook(const dat::AnimationHook& hook, const dat::Setup& setup);

private:
    struct Running {
        dat::RecordId script = 0;
        double start = 0.0;
        std::size_t first = 0; ///< of what it has started
        double period = 0.0;
    };
    void run(dat::RecordId script, double at);
    void play(const dat::AnimationHook& hook, double at);
    void create(const dat::AnimationHook& hook, double at, bool unlessThere);
    void finish(std::uint32_t name, double at, bool vanish);
    void repeat(const Running& running);

    Records& records_;
    const dat::Setup* setup_ = nullptr;
    std::vector<EmitterStart> started_;
    std::vector<Running> running_; ///< each called by the one before it
    std::size_t runs_ = 0;         ///< of scripts, since it was asked
};

/// The script for one kind of play at an intensity: the first whose greatest is not exceeded; 0 if there is none.
[[nodiscard]] dat::RecordId chooseScript(const dat::PhysicsScriptTable& table, std::uint32_t kind,
                                         float intensity);

} // namespace limen::world
