#pragma once

#include "dat/records/Models.h"

// ParticleEmitter (0x32), PhysicsScript (0x33), PhysicsScriptTable (0x34): docs/formats/effects_anim.md.
namespace limen::dat {

/// How the particles of an emitter move: positions and vectors by type are in docs/formats/effects_anim.md#motion-of-particles.
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

/// A vector and between what it is multiplied with.
struct ScaledVector {
    Vec3f vector{0.0f};
    float least = 0.0f, most = 0.0f;
};

/// Between what a value runs over a particle's life, and how far both ends may be off.
struct Fade {
    float start = 0.0f, end = 0.0f, random = 0.0f;
};

struct ParticleEmitter {
    static constexpr std::int32_t kPerSecond = 1, kPerMetre = 2;
    std::uint32_t id = 0;
    std::uint32_t unknown = 0;
    std::int32_t emitterType = kPerSecond;
    ParticleType particleType = ParticleType::Still; ///< as stored: others than the named ones are kept
    std::uint32_t softwareGfxObj = 0;
    std::uint32_t gfxObj = 0; ///< what is drawn
    double birthrate = 0.0;   ///< seconds, or metres, a particle
    std::int32_t maxParticles = 0, initialParticles = 0;
    std::int32_t totalParticles = 0;             ///< 0: no end
    double totalSeconds = 0.0;                   ///< 0: no end
    double lifespan = 0.0, lifespanRandom = 0.0; ///< seconds
    ScaledVector offset;  ///< the direction from which births lie aside, and how far, metres
    ScaledVector a, b, c; ///< by type: velocity, acceleration, rotation
    Fade scale;
    Fade translucency;               ///< 0 opaque, 1 invisible
    std::uint32_t isParentLocal = 0; ///< not 0: particles follow the emitter
};

struct ScriptedHook {
    double startTime = 0.0; ///< seconds from the script's start
    AnimationHook hook;
};

struct PhysicsScript {
    std::uint32_t id = 0;
    std::vector<ScriptedHook> hooks;
};

/// Scripts of one kind of play, the weakest first.
struct ScriptChoice {
    float most = 0.0f;        ///< the intensity up to which it is the one
    std::uint32_t script = 0; ///< PhysicsScript (0x33) id
};

struct PhysicsScriptTable {
    std::uint32_t id = 0;
    std::vector<std::pair<std::uint32_t, std::vector<ScriptChoice>>> scripts; ///< by kind of play
};

} // namespace limen::dat
