#pragma once

#include "geometry/Vec.h"
#include "world/Particles.h"

#include <algorithm>
#include <cstdint>

// Particles of the records' emitters (world/Particles.h) as closed functions of time, after
// docs/formats/effects_anim.md. The state of a particle follows from its number, the seed of its source and the
// time. Nothing is kept from frame to frame.
namespace limen::motion {

/// The times of birth of a source's particles, in seconds from its start, ascending by number. Numbers count
/// from 0, but an ever-burning source has negative numbers and times, too. At most ParticleStyle::most
/// particles live at once: a particle whose place is taken is born when the longest possible life in that
/// place is over.
class Births {
public:
    Births(const world::ParticleStyle& style, const world::ParticleSource& source);

    [[nodiscard]] double of(std::int64_t number) const;

    /// The numbers of the particles that may live `seconds` after the start: first .. last, empty if first >
    /// last.
    struct Range {
        std::int64_t first = 0, last = -1;
    };
    [[nodiscard]] Range livingAt(double seconds) const;

private:
    [[nodiscard]] std::int64_t lastBornBy(double seconds) const;
    [[nodiscard]] std::int64_t inRounds(double seconds) const;

    double interval_, life_, round_;
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

/// Identity of one particle.
struct ParticleKey {
    std::uint64_t seed = 0; ///< of source and start
    std::int64_t number = 0;
};
[[nodiscard]] ParticleKey keyOf(const world::ParticleSource& source, std::int64_t start, std::int64_t number);

/// A random number -1 <= u < 1 of a particle, a different one for each `use`.
[[nodiscard]] double signedUnit(const ParticleKey& key, std::uint32_t use);

/// The length of a particle's life in seconds.
[[nodiscard]] double lifeOf(const world::ParticleStyle& style, const ParticleKey& key);

/// Calls visit(key, born, age, life) for each particle of one start of a source that lives at a time. `born`
/// and `seconds` count from the beginning of the world.
template <class Visit>
void eachLiving(const world::ParticleStyle& style, const world::ParticleSource& source, std::int64_t start,
                double seconds, Visit&& visit) {
    const double began = source.start + static_cast<double>(start) * source.period;
    if (seconds - began >= source.gone)
        return;
    const Births births(style, source);
    const Births::Range living = births.livingAt(seconds - began);
    for (std::int64_t n = living.first; n <= living.last; ++n) {
        const double born = began + births.of(n);
        const ParticleKey key = keyOf(source, start, n);
        const double age = std::max(seconds - born, 0.0), life = lifeOf(style, key);
        if (age < life)
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
