#include "motion/Particles.h"

#include "core/Assert.h"
#include "motion/Sprites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limen::motion {
namespace {

using dat::ParticleType;
using world::ParticleSource;
using world::ParticleStyle;
using world::VectorRange;

/// The random choices of a particle.
enum Use : std::uint32_t {
    kLife,
    kAsideX,
    kAsideY,
    kAsideZ,
    kHowFarAside,
    kA,
    kB,
    kC,
    kStartScale,
    kFinalScale,
    kStartTranslucency,
    kFinalTranslucency,
    kAround,
    kUpwards,
    kStartJitter, ///< of a start of a source
    kTurn         ///< of a place
};

constexpr double kSmallest = 0.1, kLargest = 10.0; ///< scales, after docs/formats/effects_anim.md
constexpr double kNoDirection = 0.0002;            ///< shorter vectors have no direction
/// Starts of one source that are drawn at once; older ones are left out.
constexpr std::int64_t kMostStarts = 64;
constexpr double kFarNumber = 1e15; ///< up to here doubles hold every whole number

double unit(const ParticleKey& key, Use use) {
    return hashedUnit(key.seed, key.number, use);
}

Vec3 drawn(const VectorRange& range, const ParticleKey& key, Use use) {
    return range.vector * (range.least + unit(key, use) * (range.most - range.least));
}

/// The random offset of a birth, across the style's direction; in the frame of birth.
Vec3 asideOf(const ParticleStyle& style, const ParticleKey& key) {
    Vec3 v(signedUnit(key, kAsideX), signedUnit(key, kAsideY), signedUnit(key, kAsideZ));
    const Vec3& along = style.offset.vector;
    v -= along * glm::dot(along, v);
    const double length = glm::length(v);
    if (length < kNoDirection)
        return Vec3(0.0);
    const double away =
        style.offset.least + unit(key, kHowFarAside) * (style.offset.most - style.offset.least);
    return v * (away / length);
}

double ended(const dat::Fade& fade, const ParticleKey& key, Use start, Use end, double share, double least,
             double most) {
    const auto one = [&](float value, Use use) {
        return std::clamp(static_cast<double>(value) +
                              signedUnit(key, use) * static_cast<double>(fade.random),
                          least, most);
    };
    const double from = one(fade.start, start), to = one(fade.end, end);
    return from + (to - from) * share;
}

bool isLocal(ParticleType type, Use vector) {
    switch (type) {
    case ParticleType::LocalVelocity:
    case ParticleType::ParabolicLVGA:
    case ParticleType::ParabolicLVGAGR:
    case ParticleType::Swarm:
        return vector == kA;
    case ParticleType::ParabolicLVLA:
        return vector == kA || vector == kB;
    case ParticleType::ParabolicLVLALR:
        return true;
    default:
        return false;
    }
}

/// The random direction of a particle of an explosion; zero if it has none.
Vec3 burst(const Vec3& c, const ParticleKey& key) {
    const double around = std::numbers::pi * signedUnit(key, kAround),
                 up = std::numbers::pi * signedUnit(key, kUpwards);
    const Vec3 way(std::cos(around) * c.x * std::cos(up), std::sin(around) * c.y * std::cos(up),
                   std::sin(up) * c.z);
    const double length = glm::length(way);
    return length < kNoDirection ? Vec3(0.0) : way / length;
}

bool turns(ParticleType type) {
    return type == ParticleType::ParabolicLVGAGR || type == ParticleType::ParabolicLVLALR ||
           type == ParticleType::ParabolicGVGAGR;
}

/// The offset of a particle at age `t`. `o`: offset of its birth. All from the origin of the frame of birth,
/// global axes.
Vec3 placeOf(ParticleType type, const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c, double t,
             const ParticleKey& key) {
    switch (type) {
    case ParticleType::Still:
        return o;
    case ParticleType::LocalVelocity:
    case ParticleType::GlobalVelocity:
        return o + t * a;
    case ParticleType::Swarm:
        return o + t * a + Vec3(std::cos(t * b.x) * c.x, std::sin(t * b.y) * c.y, std::cos(t * b.z) * c.z);
    case ParticleType::Explode:
        return o + t * (t * b + burst(c, key) * a.x + Vec3(0.0, 0.0, a.z));
    case ParticleType::Implode: {
        const Vec3 aside = o * c;
        return aside + std::cos(a.x * t) * aside + t * t * b;
    }
    default:
        return o + t * a + 0.5 * t * t * b;
    }
}

std::int64_t wholeOf(double number) {
    if (std::isnan(number))
        return 0;
    return static_cast<std::int64_t>(std::floor(std::clamp(number, -kFarNumber, kFarNumber)));
}

} // namespace

Births::Births(const ParticleStyle& style, const ParticleSource& source)
    : interval_(source.interval), life_(style.longestLife()),
      turn_(style.lifespan > style.most * source.interval ? 0.5 * std::min(style.lifeSpread, style.lifespan)
                                                          : 0.0),
      round_(std::max(style.lifespan, style.most * source.interval)), seed_(source.seed), most_(style.most),
      initial_(style.initial), isEverBurning_(source.isEverBurning),
      secondRound_(std::max(static_cast<double>(most_ - initial_ + 1) * interval_,
                            style.lifespan + (initial_ > 0 ? 0.0 : interval_))),
      end_(style.total > 0 ? std::int64_t{style.total} : std::numeric_limits<std::int64_t>::max()),
      stop_(std::min(style.birthSeconds, source.stop)) {
    LIMEN_ASSERT(style.most > 0, "a style lets particles live");
    LIMEN_ASSERT(interval_ > 0.0, "births are some time apart");
}

/// Lives that follow one another in a place last from one shifted turn to the next. Their lengths are spread by
/// the style's spread around its lifespan, and no sum over earlier lives is needed.
double Births::shiftOf(std::int64_t number) const {
    const bool isFirst = !isEverBurning_ && number < most_;
    return turn_ > 0.0 && !isFirst ? turn_ * (2.0 * hashedUnit(seed_, number, kTurn) - 1.0) : 0.0;
}

double Births::lifeOf(const ParticleStyle& style, const ParticleKey& key) const {
    if (turn_ > 0.0)
        return of(key.number + most_) - of(key.number);
    return std::clamp(style.lifespan + signedUnit(key, kLife) * style.lifeSpread, 0.0, round_);
}

double Births::of(std::int64_t number) const {
    const auto rounds = [this](std::int64_t n) {
        const std::int64_t round = n >= 0 ? n / most_ : -((most_ - 1 - n) / most_);
        return static_cast<double>(round) * round_ + static_cast<double>(n - round * most_) * interval_;
    };
    if (isEverBurning_)
        return rounds(number) + shiftOf(number);
    if (number < initial_)
        return 0.0;
    if (number < most_)
        return static_cast<double>(number - initial_ + 1) * interval_;
    return secondRound_ + rounds(number - most_) + shiftOf(number);
}

std::int64_t Births::inRounds(double seconds) const {
    const double round = std::floor(seconds / round_);
    const double within = std::floor((seconds - round * round_) / interval_);
    return wholeOf(round) * most_ + std::clamp<std::int64_t>(wholeOf(within), 0, most_ - 1);
}

std::int64_t Births::lastBornBy(double seconds) const {
    if (isEverBurning_)
        return inRounds(seconds);
    if (seconds < 0.0)
        return -1;
    const double by = std::min(seconds, stop_);
    std::int64_t last = 0;
    if (by >= secondRound_)
        last = most_ + inRounds(by - secondRound_);
    else
        last = std::min(initial_ - 1 + wholeOf(by / interval_), most_ - 1);
    return std::min(last, end_ - 1);
}

Births::Range Births::livingAt(double seconds) const {
    return {std::max(lastBornBy(seconds - life_ - turn_) + 1,
                     isEverBurning_ ? std::numeric_limits<std::int64_t>::min() : 0),
            lastBornBy(seconds + turn_)};
}

SourceStarts startsAt(const ParticleStyle& style, const ParticleSource& source, double seconds) {
    if (source.isEverBurning)
        return {0, 0};
    const double since = seconds - source.start;
    if (source.period <= 0.0)
        return since >= 0.0 ? SourceStarts{0, 0} : SourceStarts{};
    // A start is over when its last particle has died.
    double births = std::min(style.birthSeconds, source.stop);
    if (source.interval == world::kNeverEnds)
        births = 0.0; // all particles are born at the start
    if (style.total > 0)
        births = std::min(births, Births(style, source).of(std::int64_t{style.total} - 1));
    double over = std::min(source.gone, births + style.longestLife());
    if (source.replacesItself)
        over = std::min(over, source.period + source.jitter);
    const std::int64_t last = wholeOf(since / source.period);
    const std::int64_t first =
        over < world::kNeverEnds ? wholeOf((since - over - source.jitter) / source.period) : last;
    return {std::max(first, last - kMostStarts + 1), last};
}

double startOf(const ParticleSource& source, std::int64_t start) {
    double seconds = source.start + static_cast<double>(start) * source.period;
    if (source.jitter > 0.0)
        seconds += source.jitter * hashedUnit(source.seed, start, kStartJitter);
    return seconds;
}

ParticleKey keyOf(const ParticleSource& source, std::int64_t start, std::int64_t number) {
    return {source.seed + static_cast<std::uint64_t>(start) * 0xD1B54A32D192ED03u, number};
}

double signedUnit(const ParticleKey& key, std::uint32_t use) {
    return 2.0 * hashedUnit(key.seed, key.number, use) - 1.0;
}

ParticleState particleAt(const ParticleStyle& style, const ParticleKey& key, double age, double life,
                         const Quat& born, const Vec3& offset) {
    const auto vectorOf = [&](const VectorRange& range, Use use) {
        const Vec3 v = drawn(range, key, use);
        return isLocal(style.type, use) ? born * v : v;
    };
    const Vec3 a = vectorOf(style.a, kA), b = vectorOf(style.b, kB), c = vectorOf(style.c, kC);
    ParticleState state;
    state.offset = placeOf(style.type, born * (offset + asideOf(style, key)), a, b, c, age, key);
    state.orientation = born;
    if (const double turn = glm::length(c) * age; turns(style.type) && turn > 0.0)
        state.orientation = glm::angleAxis(turn, glm::normalize(c)) * born;
    const double share = life > 0.0 ? std::clamp(age / life, 0.0, 1.0) : 1.0;
    state.scale = ended(style.scale, key, kStartScale, kFinalScale, share, kSmallest, kLargest);
    state.opacity =
        1.0 - ended(style.translucency, key, kStartTranslucency, kFinalTranslucency, share, 0.0, 1.0);
    return state;
}

} // namespace limen::motion
