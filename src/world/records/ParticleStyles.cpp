#include "world/records/ParticleStyles.h"

#include "core/Assert.h"
#include "world/World.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Seconds between two births at least. The original client creates one particle an update at most.
constexpr double kLeastInterval = 0.001;
constexpr double kLongestLife = 1e9; ///< seconds; practically endless, and sums of it are still finite
constexpr float kSmallest = 0.1f,
                kLargest = 10.0f; ///< limits of scales. docs/formats/effects_anim.md#drawing-particles

double finite(double value) {
    return std::isfinite(value) ? value : 0.0;
}

VectorRange rangeOf(const dat::ScaledVector& in) {
    const Vec3 vector(in.vector);
    return {isFinite(vector) ? vector : Vec3(0.0), finite(static_cast<double>(in.least)),
            finite(static_cast<double>(in.most))};
}

dat::Fade fadeOf(const dat::Fade& in) {
    const auto number = [](float v) { return std::isfinite(v) ? v : 0.0f; };
    return {number(in.start), number(in.end), std::abs(number(in.random))};
}

/// The greatest length of a vector in the range.
double mostOf(const VectorRange& range) {
    return glm::length(range.vector) * std::max(std::abs(range.least), std::abs(range.most));
}

std::uint32_t countOf(std::int32_t count) {
    return static_cast<std::uint32_t>(std::clamp<std::int32_t>(count, 0, kMostSprites));
}

double largestScale(const dat::Fade& scale) {
    return static_cast<double>(
        std::clamp(std::max(scale.start, scale.end) + scale.random, kSmallest, kLargest));
}

/// The greatest distance of a particle from its place of birth, by its motion alone, metres. `births`: the
/// greatest distance of that place from the emitter.
double mostWay(const ParticleStyle& style, double births) {
    const double life = style.longestLife();
    const double a = mostOf(style.a), b = mostOf(style.b), c = mostOf(style.c);
    switch (style.type) {
    case dat::ParticleType::Still:
        return 0.0;
    case dat::ParticleType::LocalVelocity:
    case dat::ParticleType::GlobalVelocity:
        return a * life;
    case dat::ParticleType::Swarm:
        return a * life + c;
    case dat::ParticleType::Explode:        // C is a direction
        return life * (life * b + 2.0 * a); // A.x along a direction, and A.z upwards
    case dat::ParticleType::Implode:        // it leaves by its distance from the emitter, and returns
        return births * c + births * c + life * life * b;
    default:
        return a * life + 0.5 * b * life * life;
    }
}

} // namespace

std::optional<ParticleStyle> particleStyleOf(const dat::ParticleEmitter& record) {
    ParticleStyle style;
    style.record = record.id;
    style.type = record.particleType;
    if (style.type < dat::ParticleType::Still || style.type > dat::ParticleType::GlobalVelocity)
        style.type = dat::ParticleType::Still;
    style.isParentLocal = record.isParentLocal != 0;
    style.isPerMetre = record.emitterType == dat::ParticleEmitter::kPerMetre;
    if (std::isfinite(record.birthrate))
        style.interval = std::max(record.birthrate, style.isPerMetre ? 1e-3 : kLeastInterval);
    style.most = countOf(record.maxParticles);
    style.initial = std::min(countOf(record.initialParticles), style.most);
    style.total = static_cast<std::uint32_t>(std::max(record.totalParticles, 0));
    if (record.totalSeconds > 0.0)
        style.birthSeconds = record.totalSeconds;
    LIMEN_ASSERT(style.initial <= style.most && style.most <= kMostSprites, "counts are clamped");
    style.lifespan = std::clamp(finite(record.lifespan), 0.0, kLongestLife);
    style.lifeSpread = std::min(std::abs(finite(record.lifespanRandom)), kLongestLife);
    style.offset = rangeOf(record.offset);
    style.a = rangeOf(record.a);
    style.b = rangeOf(record.b);
    style.c = rangeOf(record.c);
    style.scale = fadeOf(record.scale);
    style.translucency = fadeOf(record.translucency);
    if (style.most == 0 || !(style.longestLife() > 0.0))
        return std::nullopt;
    return style;
}

double particleReach(const ParticleStyle& style, const Vec3& offset) {
    const double aside = std::max(std::abs(style.offset.least), std::abs(style.offset.most));
    const double births = glm::length(offset) + aside;
    const double away = style.type == dat::ParticleType::Implode ? 0.0 : births;
    return away + mostWay(style, births) + style.size * largestScale(style.scale);
}

} // namespace limen::world
