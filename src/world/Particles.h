#pragma once

#include "dat/Ids.h"
#include "dat/records/Effects.h"
#include "world/Cycle.h"
#include "world/Index.h"

#include <cstdint>
#include <limits>

// Particle emitters of the records, as a World holds them: read from ParticleEmitter (0x32), PhysicsScript (0x33) and
// PhysicsScriptTable (0x34) records by world/EmitterStarts.h, evaluated by motion/Particles.h. After docs/formats/effects_anim.md.
// Lengths in metres, times in seconds.
namespace limen::world {

inline constexpr double kNeverEnds = std::numeric_limits<double>::infinity();

/// A vector, and between what it is multiplied with for each particle.
struct VectorRange {
    Vec3 vector{0.0};
    double least = 0.0, most = 0.0;
};

/// How the particles of one ParticleEmitter record look, come and go.
struct ParticleStyle {
    dat::RecordId record = 0;
    dat::ParticleType type = dat::ParticleType::Still;
    std::uint32_t part = kNone;       ///< World::movingParts: what is drawn for each; kNone: nothing
    bool facesEye = false;            ///< its part's x, y and z are the eye's right, forward and up
    bool isParentLocal = false;       ///< particles keep their places relative to what carries the emitter
    bool isPerMetre = false;          ///< births follow the metres that the carrier goes, else the seconds
    double interval = kNeverEnds;     ///< seconds or metres from birth to birth
    std::uint32_t most = 0;           ///< that live at once
    std::uint32_t initial = 0;        ///< born as it starts; at most `most`
    std::uint32_t total = 0;          ///< born altogether; 0: no end
    double birthSeconds = kNeverEnds; ///< from its start until births end
    double lifespan = 0.0, lifeSpread = 0.0; ///< a life lasts lifespan ± lifeSpread
    VectorRange offset;                      ///< across which direction births lie aside, and how far
    VectorRange a, b, c;                     ///< by type
    dat::Fade scale, translucency;
    double size = 0.0; ///< farthest corner of what is drawn from its origin, at scale 1

    [[nodiscard]] double longestLife() const { return lifespan + lifeSpread; }
    /// Whether it goes on for ever.
    [[nodiscard]] bool isEndless() const { return total == 0 && birthSeconds == kNeverEnds; }
};

/// An emitter that a script starts on something that stands or walks in the world: once, or again and again.
struct ParticleSource {
    std::uint32_t style = kNone;    ///< index into World::particleStyles
    std::uint32_t villager = kNone; ///< carried by one of World::villagers,
    std::uint32_t idle = kNone;     ///< or of World::idleObjects, or by neither:
    PartFrame at; ///< then its frame, global; else that of its part as it rests, in the carrier's own frame
    SpaceIndex space = kOutside;  ///< that `at` is in, if nothing carries it
    std::uint32_t part = kNone;   ///< of a carrier: of its Setup; kNone: the carrier itself
    Vec3 offset{0.0};             ///< births', in its frame
    double interval = kNeverEnds; ///< seconds from birth to birth
    /// World::cycles: a cycle that its carrier plays, whose frame starts it; then `start` and `period` are in that cycle's own
    /// seconds. kNone: they are of the world.
    std::uint32_t cycle = kNone;
    bool replacesItself = false; ///< each start of it puts an end to the one before
    double start = 0.0;          ///< seconds since the world, or the cycle, began
    double period = 0.0;         ///< from each start to the next, before the first as well; 0: it starts once
    double stop = kNeverEnds;    ///< seconds from each start until births end
    double gone = kNeverEnds;    ///< seconds from each start until all that is left vanishes
    /// It is endless, and has always been sending out particles, whatever `start` says.
    bool isEverBurning = false;
    bool isAlone =
        false; ///< no particle reaches another space than `space`, whichever doors are open; only if not carried
    std::uint64_t seed = 0; ///< tells it from all others
    double reach = 0.0;     ///< no particle of it comes farther from where it was born than this
};

} // namespace limen::world
