#pragma once

#include "dat/records/Models.h"

// ParticleEmitter (0x32), PhysicsScript (0x33), PhysicsScriptTable (0x34): docs/formats/effects_anim.md.
LIMEN_API_BEGIN
namespace limen::dat {

/// The motion of an emitter's particles; docs/formats/effects_anim.md has the formulas.
enum class ParticleType : std::int32_t {
    Still = 1,
    LocalVelocity,
    ParabolicLVGA,
    ParabolicLVGAGR,
    Swarm,
    Explode,
    Implode,
    ParabolicLVLA,
    ParabolicLVLALR,
    ParabolicGVGA,
    ParabolicGVGAGR,
    GlobalVelocity
};

/// A vector, and the range of a random factor.
struct ScaledVector {
    Vec3f vector{0.0f};
    float least = 0.0f, most = 0.0f;
};

/// The first and last value over a particle's life, and the random variation of both.
struct Fade {
    float start = 0.0f, end = 0.0f, random = 0.0f;
};

struct ParticleEmitter {
    static constexpr std::int32_t kPerSecond = 1, kPerMetre = 2;
    std::uint32_t id = 0;
    std::uint32_t unknown = 0;
    std::int32_t emitterType = kPerSecond;
    ParticleType particleType = ParticleType::Still; ///< as stored; values without a name are kept
    std::uint32_t softwareGfxObj = 0;
    std::uint32_t gfxObj = 0; ///< the drawn model
    double birthrate = 0.0;   ///< seconds or metres between particles
    std::int32_t maxParticles = 0, initialParticles = 0;
    std::int32_t totalParticles = 0;             ///< 0: unlimited
    double totalSeconds = 0.0;                   ///< 0: no end
    double lifespan = 0.0, lifespanRandom = 0.0; ///< seconds
    ScaledVector offset;  ///< births are offset perpendicular to this direction, by metres
    ScaledVector a, b, c; ///< by type: velocity, acceleration, rotation
    Fade scale;
    Fade translucency;               ///< 0 opaque, 1 invisible
    std::uint32_t isParentLocal = 0; ///< nonzero: particles follow the emitter
};

struct ScriptedHook {
    double startTime = 0.0; ///< seconds from the script's start
    AnimationHook hook;
};

struct PhysicsScript {
    std::uint32_t id = 0;
    std::vector<ScriptedHook> hooks;
};

/// One script of a play and the intensities for which it is used.
struct ScriptChoice {
    float most = 0.0f;        ///< the greatest intensity for which it is used
    std::uint32_t script = 0; ///< PhysicsScript (0x33) id
};

struct PhysicsScriptTable {
    std::uint32_t id = 0;
    std::vector<std::pair<std::uint32_t, std::vector<ScriptChoice>>>
        scripts; ///< by play; for each, the weakest script first
};

} // namespace limen::dat
LIMEN_API_END
