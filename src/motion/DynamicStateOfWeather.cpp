#include "motion/DynamicStateBuilder.h"

#include "motion/Particles.h"
#include "motion/Sprites.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// The part of Moments that falls around the eye. Weather belongs to the outside alone, however near to a door it falls.
namespace limen::motion {
namespace {

// Rain: columns of drops on a grid that is fixed in the world, so that the eye moves through standing rain.
constexpr double kRainGrid = 1.5, kRainRadius = 10.5; // metres
constexpr double kRainBelow = 4.0, kRainPeriod = 6.0, kRainSpeed = 9.0;
constexpr int kRainPerColumn = 2; // periods above each other
constexpr Vec2 kRainSize{0.012, 0.5};

// Weather of the Region. Its emitters are at the eye; here they stand on a grid that is fixed in the world on the level, one in each
// square, and births are spread evenly over it, so that the eye moves through what falls. As many lie around it as one emitter has.
constexpr double kLeastSpread = 1.0; ///< metres; what is born closer together goes with the eye

constexpr double kMostSquares = 2.0; ///< what drifts farther than so many comes from nowhere

/// What chance decides beyond what motion/Particles.cpp lets it.
enum PlaceUse : std::uint32_t { kAcrossArea = 100, kAlongArea, kAboveArea };

/// From a place to the nearest point of a square on the level.
double distanceTo(const Vec2& middle, double half, const Vec2& place) {
    const Vec2 beyond = glm::max(glm::abs(place - middle) - half, Vec2(0.0));
    return glm::length(beyond);
}

} // namespace

void DynamicStateBuilder::addRain(const DynamicStateInput& input, world::DynamicState& out) {
    // Weather belongs to the outside alone, however near to a door a drop falls.
    DynamicStateInput facing = input;
    facing.up = Vec3(0.0, 0.0, 1.0);
    const auto reach = static_cast<int>(kRainRadius / kRainGrid);
    const auto middleX = static_cast<std::int64_t>(std::floor(input.eye.x / kRainGrid));
    const auto middleY = static_cast<std::int64_t>(std::floor(input.eye.y / kRainGrid));
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            const std::int64_t column = (middleX + i) * 0x10000 + middleY + j;
            for (int k = 0; k < kRainPerColumn && sprites_ < world::kMostSprites; ++k) {
                const auto seed = static_cast<std::uint64_t>(k);
                const double x = static_cast<double>(middleX + i) + hashedUnit(seed, column, 0);
                const double y = static_cast<double>(middleY + j) + hashedUnit(seed, column, 1);
                const double low = input.eye.z - kRainBelow + k * kRainPeriod;
                const double fall =
                    hashedUnit(seed, column, 2) * kRainPeriod - kRainSpeed * input.seconds - low;
                const Vec3 at(x * kRainGrid, y * kRainGrid,
                              low + fall - std::floor(fall / kRainPeriod) * kRainPeriod);
                const Vec3 towards = at - input.eye;
                const double flat = std::hypot(towards.x, towards.y);
                if (flat < 1e-3)
                    continue;
                facing.forward = Vec3(towards.x / flat, towards.y / flat, 0.0);
                facing.right = Vec3(facing.forward.y, -facing.forward.x, 0.0);
                addSprite(facing, world_.rainDrop, at, kRainSize, 1.0, out);
                reached_.assign(1, world::kOutside);
                giveMembers(out.instances.size() - 1, out);
            }
        }
    }
}

void DynamicStateBuilder::addWeather(const DynamicStateInput& input, world::DynamicState& out) {
    for (const world::SkyWeather& weather : world_.sky.weather) {
        if (weather.dayGroup != input.weather->dayGroup ||
            !world::isShown(weather.object, input.weather->time))
            continue;
        const double radius = std::max(weather.spread.x, weather.spread.y);
        if (radius < kLeastSpread) {
            addFalling(input, weather, input.eye, 0.0, weather.source.seed, out);
            continue;
        }
        const double side =
            radius * std::sqrt(std::numbers::pi); // a square as large as the circle around the eye
        const double around = std::min(radius + weather.drift, kMostSquares * side);
        const auto squareOf = [&](double metres) {
            return static_cast<std::int64_t>(std::floor(metres / side));
        };
        for (std::int64_t i = squareOf(input.eye.x - around); i <= squareOf(input.eye.x + around); ++i) {
            for (std::int64_t j = squareOf(input.eye.y - around); j <= squareOf(input.eye.y + around); ++j) {
                const Vec2 middle = (Vec2(static_cast<double>(i), static_cast<double>(j)) + 0.5) * side;
                const std::uint64_t square =
                    static_cast<std::uint64_t>(i * 0x10000 + j) * 0x9E3779B97F4A7C15u;
                if (distanceTo(middle, 0.5 * side, Vec2(input.eye)) <= around)
                    addFalling(input, weather, Vec3(middle, input.eye.z), side, weather.source.seed ^ square,
                               out);
            }
        }
    }
}

void DynamicStateBuilder::addFalling(const DynamicStateInput& input, const world::SkyWeather& weather,
                                     const Vec3& middle, double side, std::uint64_t seed,
                                     world::DynamicState& out) {
    const world::ParticleStyle& style = world_.particleStyles[weather.source.style];
    world::ParticleSource source = timed(weather.source).value_or(weather.source);
    source.seed = seed;
    const Vec3 half = side > 0.0 ? Vec3(0.5 * side, 0.5 * side, weather.spread.z) : weather.spread;
    const double radius = side > 0.0 ? std::max(weather.spread.x, weather.spread.y) : world::kNeverEnds;
    const Carrier from{middle, Quat(1.0, 0.0, 0.0, 0.0), world::kOutside};
    const std::uint32_t block = blockFor(middle);
    const SourceStarts starts = startsAt(style, source, input.seconds);
    for (std::int64_t start = starts.first; start <= starts.last; ++start) {
        eachLiving(style, source, start, input.seconds,
                   [&](const ParticleKey& key, double, double age, double life) {
                       const Vec3 aside =
                           half * Vec3(signedUnit(key, kAcrossArea), signedUnit(key, kAlongArea),
                                       signedUnit(key, kAboveArea));
                       const ParticleState state =
                           particleAt(style, key, age, life, from.orientation, source.offset + aside);
                       if (glm::length(Vec2(middle + state.offset - input.eye)) <= radius)
                           addParticle(input, source, from, state, block, out);
                   });
    }
}

} // namespace limen::motion
