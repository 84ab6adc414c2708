#pragma once

#include "dat/Ids.h"
#include "dat/records/Effects.h"
#include "world/Cycle.h"
#include "world/Facing.h"
#include "world/Index.h"

#include <cstdint>
#include <limits>

// Particle emitters of the records, as a World stores them: read from ParticleEmitter (0x32), PhysicsScript
// (0x33) and PhysicsScriptTable (0x34) records by world/records/EmitterStarts.h, evaluated by
// motion/Particles.h. docs/formats/effects_anim.md#particleemitter. Lengths in metres, times in seconds.
namespace limen::world {

inline constexpr double kNeverEnds = std::numeric_limits<double>::infinity();

/// A vector and the limits of the random factor that each particle multiplies it by.
struct VectorRange {
    Vec3 vector{0.0};
    double least = 0.0, most = 0.0;
};

/// The appearance, births and motion of the particles of one ParticleEmitter record.
struct ParticleStyle {
    dat::RecordId record = 0;
    dat::ParticleType type = dat::ParticleType::Still;
    std::uint32_t part = kNone;       ///< World::movingParts: the part drawn for each particle; kNone: none
    Facing facing = Facing::Fixed;    ///< how each particle turns to the eye
    bool isParentLocal = false;       ///< particles move with the carrier of the emitter
    bool isPerMetre = false;          ///< true: births by the carrier's distance; false: by time
    double interval = kNeverEnds;     ///< seconds or metres from birth to birth
    std::uint32_t most = 0;           ///< particles alive at the same time
    std::uint32_t initial = 0;        ///< particles born at the start; at most `most`
    std::uint32_t total = 0;          ///< particles born in all; 0: no limit
    double birthSeconds = kNeverEnds; ///< from its start until births end
    double lifespan = 0.0, lifeSpread = 0.0; ///< a life lasts lifespan ± lifeSpread
    VectorRange offset;                      ///< births are displaced across its direction, by its factor
    VectorRange a, b, c;                     ///< parameters of the motion; their meaning depends on `type`
    dat::Fade scale, translucency;
    double size = 0.0; ///< distance of the part's farthest corner from its origin, at scale 1

    [[nodiscard]] double longestLife() const { return lifespan + lifeSpread; }
    /// True if births never end.
    [[nodiscard]] bool isEndless() const { return total == 0 && birthSeconds == kNeverEnds; }
};

/// An emitter that a script starts on an object or villager, once or repeatedly. Its carrier is a villager,
/// an idle object, or none (a static object).
struct ParticleSource {
    std::uint32_t style = kNone;    ///< index into World::particleStyles
    std::uint32_t villager = kNone; ///< carrier: index into World::villagers
    std::uint32_t idle = kNone;     ///< carrier: index into World::idleObjects
    PartFrame at; ///< of a carrier: the resting pose of its part, in the carrier's own frame; else global
    SpaceIndex space = kOutside;  ///< without a carrier: the space of `at`
    std::uint32_t part = kNone;   ///< of a carrier: index of the part in its Setup; kNone: the whole carrier
    Vec3 offset{0.0};             ///< of births, in the frame of `at` or of the part
    double interval = kNeverEnds; ///< seconds from birth to birth
    /// World::cycles: the carrier's cycle whose frame starts the source; `start` and `period` are seconds of
    /// that cycle. kNone: they are seconds of the world.
    std::uint32_t cycle = kNone;
    bool replacesItself = false; ///< each start ends the one before
    double start = 0.0;          ///< seconds since the start of the world or of the cycle
    double period = 0.0;      ///< mean seconds from start to start, also before the first one; 0: one start
    double jitter = 0.0;      ///< seconds: each start of several is later by a random share of this
    double stop = kNeverEnds; ///< seconds from each start until births end
    double gone = kNeverEnds; ///< seconds from each start until its remaining particles are removed
    /// It is endless and has particles at every time, regardless of `start`.
    bool isEverBurning = false;
    /// No particle reaches a space other than `space`, even with all doors open. False with a carrier.
    bool isAlone = false;
    std::uint64_t seed = 0; ///< unique
    double reach = 0.0;     ///< greatest distance of a particle's points from the frame it is born in
};

} // namespace limen::world
