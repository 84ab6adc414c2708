#pragma once

#include "geometry/Vec.h"
#include "world/Particles.h"

#include <algorithm>
#include <cstdint>

// Particles of the records' emitters (world/Particles.h) as closed functions of time: each has a number, and all about it follows from
// that, its source's seed and the time, after docs/formats/effects_anim.md. Nothing is remembered from moment to moment.
namespace limen::motion {

/// When particles of a source are born, in seconds from its start, by number, ascending. Of one that has always been burning numbers
/// and times may be negative; else numbers count from 0. At most ParticleStyle::most live at once: one whose place is still
/// taken is born when the longest life there can be is over.
class Births {
public:
    Births(const world::ParticleStyle& style, const world::ParticleSource& source);

    [[nodiscard]] double of(std::int64_t number) const;

    /// Numbers that may live `seconds` after the start: first .. last, empty if first > last.
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
    double secondRound_; ///< when the first places are taken again
    std::int64_t end_;   ///< one past the last number
    double stop_;        ///< no births later than this
};

/// The starts of a source that may still have particles at a time, by number: first .. last, empty if first > last.
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

/// -1 <= u < 1, another one for each `use`.
[[nodiscard]] double signedUnit(const ParticleKey& key, std::uint32_t use);

/// How long a particle lives, seconds.
[[nodiscard]] double lifeOf(const world::ParticleStyle& style, const ParticleKey& key);

/// Calls visit(key, born, age, life) for each particle of one start of a source that lives then; `born` and `seconds`: since the world
/// began.
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
    Vec3 offset{0.0};                     ///< global axes: from the origin of its place of birth's frame
    Quat orientation{1.0, 0.0, 0.0, 0.0}; ///< global
    double scale = 1.0, opacity = 1.0;
};

/// `age`: seconds, 0..life. `born`: orientation of the frame it was born in. `offset`: the emitter's own, in that frame.
[[nodiscard]] ParticleState particleAt(const world::ParticleStyle& style, const ParticleKey& key, double age,
                                       double life, const Quat& born, const Vec3& offset);

} // namespace limen::motion
