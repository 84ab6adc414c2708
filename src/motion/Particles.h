#pragma once

#include "geometry/Vec.h"
#include "world/Particles.h"

#include <algorithm>
#include <cstdint>

// Particles of the records' emitters (world/Particles.h) as closed functions of time, after
// docs/formats/effects_anim.md. The state of a particle follows from its number, the seed of its source and the
// time. Nothing is kept from frame to frame.
namespace limen::motion {

/// Identity of one particle.
struct ParticleKey {
    std::uint64_t seed = 0; ///< of source and start
    std::int64_t number = 0;
};
[[nodiscard]] ParticleKey keyOf(const world::ParticleSource& source, std::int64_t start, std::int64_t number);

/// A random number -1 <= u < 1 of a particle, a different one for each `use`.
[[nodiscard]] double signedUnit(const ParticleKey& key, std::uint32_t use);

/// The times of birth of a source's particles, in seconds from its start. Numbers count from 0, but an
/// ever-burning source has negative numbers and times, too. Births are ParticleSource::interval apart while
/// places are free. At most ParticleStyle::most particles live at once: one whose place is taken is born when
/// the particle in that place dies.
class Births {
public:
    Births(const world::ParticleStyle& style, const world::ParticleSource& source);

    [[nodiscard]] double of(std::int64_t number) const;
    /// The length of a particle's life in seconds. Lives end when their place is taken again.
    [[nodiscard]] double lifeOf(const world::ParticleStyle& style, const ParticleKey& key) const;

    /// The numbers of the particles that may live `seconds` after the start: first .. last, empty if first >
    /// last. Some of them may be dead, or not born.
    struct Range {
        std::int64_t first = 0, last = -1;
    };
    [[nodiscard]] Range livingAt(double seconds) const;

private:
    [[nodiscard]] std::int64_t lastBornBy(double seconds) const;
    [[nodiscard]] std::int64_t inRounds(double seconds) const;

    /// How much later than its turn a place is taken, seconds; 0 unless lives follow one another.
    [[nodiscard]] double shiftOf(std::int64_t number) const;

    double interval_, life_;
    double turn_;  ///< half the spread of lives that follow one another in a place, seconds; else 0
    double round_; ///< mean seconds from birth to birth in one place
    std::uint64_t seed_;
    std::int64_t most_, initial_;
    bool isEverBurning_;
    double secondRound_; ///< seconds from the start when the first places are taken again
    std::int64_t end_;   ///< one past the last number
    double stop_;        ///< seconds from the start of the last birth
};

/// The numbers of a source's starts that may have living particles at a time: first .. last, empty if first >
/// last.
struct SourceStarts {
    std::int64_t first = 0, last = -1;
};
[[nodiscard]] SourceStarts startsAt(const world::ParticleStyle& style, const world::ParticleSource& source,
                                    double seconds);

/// Seconds from the beginning of the world to one start.
[[nodiscard]] double startOf(const world::ParticleSource& source, std::int64_t start);

/// Calls visit(key, born, age, life) for each particle of one start of a source that lives at a time. `born`
/// and `seconds` count from the beginning of the world.
template <class Visit>
void eachLiving(const world::ParticleStyle& style, const world::ParticleSource& source, std::int64_t start,
                double seconds, Visit&& visit) {
    const double began = startOf(source, start);
    const double gone =
        source.replacesItself ? std::min(source.gone, startOf(source, start + 1) - began) : source.gone;
    if (seconds - began >= gone)
        return;
    const Births births(style, source);
    const Births::Range living = births.livingAt(seconds - began);
    for (std::int64_t n = living.first; n <= living.last; ++n) {
        const double born = began + births.of(n);
        const ParticleKey key = keyOf(source, start, n);
        const double age = seconds - born, life = births.lifeOf(style, key);
        if (age >= 0.0 && age < life)
            visit(key, born, age, life);
    }
}

/// A particle at one age.
struct ParticleState {
    Vec3 offset{0.0};                     ///< global axes; from the origin of the frame of birth
    Quat orientation{1.0, 0.0, 0.0, 0.0}; ///< global
    double scale = 1.0, opacity = 1.0;
};

/// `age`: seconds, 0..life. `born`: orientation of the frame of birth. `offset`: the emitter's own, in that
/// frame.
[[nodiscard]] ParticleState particleAt(const world::ParticleStyle& style, const ParticleKey& key, double age,
                                       double life, const Quat& born, const Vec3& offset);

} // namespace limen::motion
