#include "motion/Sprites.h"

#include "core/Assert.h"

#include <cmath>
#include <numbers>

namespace limen::motion {
namespace {

enum SphereUse : std::uint32_t { kSphereAround, kSphereOut, kSphereUp, kSpreadX, kSpreadY, kSpreadZ };

/// A random point of the sphere of radius 1, surface and inside.
Vec3 inUnitSphere(std::uint32_t seed, std::int64_t number) {
    const double around = 2.0 * std::numbers::pi * hashedUnit(seed, number, kSphereAround);
    const double z = 2.0 * hashedUnit(seed, number, kSphereUp) - 1.0;
    const double flat = std::sqrt(1.0 - z * z);
    return Vec3(flat * std::cos(around), flat * std::sin(around), z) *
           std::cbrt(hashedUnit(seed, number, kSphereOut));
}

} // namespace

SpriteRange livingAt(const world::Emitter& emitter, double seconds) {
    LIMEN_ASSERT(emitter.rate > 0.0 && emitter.life > 0.0, "an emitter has a rate, and its sprites a life");
    return {static_cast<std::int64_t>(std::floor((seconds - emitter.life) * emitter.rate)) + 1,
            static_cast<std::int64_t>(std::floor(seconds * emitter.rate))};
}

SpriteState spriteAt(const world::Emitter& emitter, std::int64_t number, double seconds) {
    const double age = seconds - static_cast<double>(number) / emitter.rate;
    const double share = std::min(std::max(age / emitter.life, 0.0), 1.0);
    const Vec3 spread =
        (2.0 * Vec3(hashedUnit(emitter.seed, number, kSpreadX), hashedUnit(emitter.seed, number, kSpreadY),
                    hashedUnit(emitter.seed, number, kSpreadZ)) -
         1.0) *
        emitter.spread;
    SpriteState state;
    state.offset = inUnitSphere(emitter.seed, number) * emitter.radius + (emitter.velocity + spread) * age +
                   emitter.acceleration * (0.5 * age * age);
    state.size = emitter.size[0] + (emitter.size[1] - emitter.size[0]) * share;
    state.opacity = emitter.alpha[0] + (emitter.alpha[1] - emitter.alpha[0]) * share;
    return state;
}

} // namespace limen::motion
