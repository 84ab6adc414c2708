#include "motion/WeatherInstances.h"

#include "core/Assert.h"
#include "motion/EffectInstances.h"
#include "motion/Sprites.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::motion {
namespace {

using world::kNone;

// Rain is columns of drops on a grid that is fixed in the world: a moving eye passes through rain that does
// not move along with it.
constexpr double kRainGrid = 1.5;     ///< metres between columns
constexpr double kRainRadius = 10.5;  ///< metres around the eye, along x and y
constexpr double kRainBelow = 4.0;    ///< metres below the eye where the columns begin
constexpr double kRainPeriod = 6.0;   ///< metres: height of the part of a column that repeats
constexpr double kRainSpeed = 9.0;    ///< metres a second, down
constexpr int kRainPerColumn = 2;     ///< periods above each other
constexpr Vec2 kRainSize{0.012, 0.5}; ///< metres, across and up

/// A drop nearer to the eye than this on the level is a bar across the picture; metres.
constexpr double kNearestDrop = 0.5;

// The Region's weather has emitters at the eye. Here the emitters are on a level grid that is fixed in the
// world, one in each square, and births are spread evenly over the square. The squares around the eye hold as
// many particles as one emitter at the eye.

/// Metres: weather that is born closer together than this stays at the eye instead.
constexpr double kLeastSpread = 1.0;
/// Squares that a particle may drift; particles from farther away are left out.
constexpr double kMostSquares = 2.0;

/// Random choices beside those of motion/Particles.cpp.
enum PlaceUse : std::uint32_t { kAcrossArea = 100, kAlongArea, kAboveArea };

/// The distance of a place from the nearest point of a level square.
double distanceTo(const Vec2& middle, double half, const Vec2& place) {
    const Vec2 beyond = glm::max(glm::abs(place - middle) - half, Vec2(0.0));
    return glm::length(beyond);
}

/// Appends the drop of one period of one column, turned to the eye about the vertical.
void addDrop(const DynamicStateInput& input, std::int64_t columnX, std::int64_t columnY, int period,
             DynamicInstances& instances) {
    const std::int64_t column = columnX * 0x10000 + columnY;
    const auto seed = static_cast<std::uint64_t>(period);
    const double x = static_cast<double>(columnX) + hashedUnit(seed, column, 0);
    const double y = static_cast<double>(columnY) + hashedUnit(seed, column, 1);
    const double low = input.eye.z - kRainBelow + period * kRainPeriod;
    const double fall = hashedUnit(seed, column, 2) * kRainPeriod - kRainSpeed * input.seconds - low;
    const Vec3 at(x * kRainGrid, y * kRainGrid, low + fall - std::floor(fall / kRainPeriod) * kRainPeriod);
    const Vec3 towards = at - input.eye;
    const double flat = std::hypot(towards.x, towards.y);
    if (flat < kNearestDrop)
        return;
    SpriteShape drop{instances.world().rainDrop, kRainSize};
    drop.forward = Vec3(towards.x / flat, towards.y / flat, 0.0);
    drop.right = Vec3(drop.forward.y, -drop.forward.x, 0.0);
    const std::size_t first = addSprite(drop, at, instances);
    instances.setSpaces(first, instances.only(world::kOutside));
}

void addRain(const DynamicStateInput& input, DynamicInstances& instances) {
    const auto reach = static_cast<int>(kRainRadius / kRainGrid);
    const auto middleX = static_cast<std::int64_t>(std::floor(input.eye.x / kRainGrid));
    const auto middleY = static_cast<std::int64_t>(std::floor(input.eye.y / kRainGrid));
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (int k = 0; k < kRainPerColumn && instances.hasSpriteIds(1); ++k)
                addDrop(input, middleX + i, middleY + j, k, instances);
}

/// One emitter of the Region's weather.
struct WeatherEmitter {
    const world::SkyWeather& weather;
    Vec3 middle{0.0};       ///< of the square that particles are born over, global
    double side = 0.0;      ///< of the square, metres; 0: the emitter is at the eye and has no square
    std::uint64_t seed = 0; ///< differs from square to square
};

void addEmitter(const DynamicStateInput& input, const WeatherEmitter& emitter, DynamicInstances& instances) {
    const world::World& world = instances.world();
    const world::SkyWeather& weather = emitter.weather;
    const world::ParticleStyle& style = world.particleStyles[weather.source.style];
    world::ParticleSource source = inWorldTime(world, weather.source).value_or(weather.source);
    source.seed = emitter.seed;
    const bool hasSquare = emitter.side > 0.0;
    const Vec3 half =
        hasSquare ? Vec3(0.5 * emitter.side, 0.5 * emitter.side, weather.spread.z) : weather.spread;
    const double radius = hasSquare ? std::max(weather.spread.x, weather.spread.y) : world::kNeverEnds;
    const CarrierFrame frame{emitter.middle, Quat(1.0, 0.0, 0.0, 0.0), world::kOutside};
    const ParticleOrigin from{source, frame, instances.blockFor(emitter.middle)};
    const SourceStarts starts = startsAt(style, source, input.seconds);
    for (std::int64_t start = starts.first; start <= starts.last; ++start) {
        eachLiving(style, source, start, input.seconds,
                   [&](const ParticleKey& key, double, double age, double life) {
                       const Vec3 aside =
                           half * Vec3(signedUnit(key, kAcrossArea), signedUnit(key, kAlongArea),
                                       signedUnit(key, kAboveArea));
                       const ParticleState state =
                           particleAt(style, key, age, life, frame.orientation, source.offset + aside);
                       if (glm::length(Vec2(emitter.middle + state.offset - input.eye)) <= radius)
                           addParticle(input, from, state, instances);
                   });
    }
}

/// Appends the emitters of all squares from which particles may drift into the circle around the eye.
void addSquares(const DynamicStateInput& input, const world::SkyWeather& weather, double radius,
                DynamicInstances& instances) {
    LIMEN_ASSERT(radius >= kLeastSpread, "squares are not smaller than the least spread");
    const double side =
        radius * std::sqrt(std::numbers::pi); // a square of the same area as the circle around the eye
    const double around = std::min(radius + weather.drift, kMostSquares * side);
    const auto squareOf = [&](double metres) { return static_cast<std::int64_t>(std::floor(metres / side)); };
    for (std::int64_t i = squareOf(input.eye.x - around); i <= squareOf(input.eye.x + around); ++i) {
        for (std::int64_t j = squareOf(input.eye.y - around); j <= squareOf(input.eye.y + around); ++j) {
            const Vec2 middle = (Vec2(static_cast<double>(i), static_cast<double>(j)) + 0.5) * side;
            const std::uint64_t square = static_cast<std::uint64_t>(i * 0x10000 + j) * 0x9E3779B97F4A7C15u;
            if (distanceTo(middle, 0.5 * side, Vec2(input.eye)) <= around)
                addEmitter(input, {weather, Vec3(middle, input.eye.z), side, weather.source.seed ^ square},
                           instances);
        }
    }
}

} // namespace

void addWeather(const DynamicStateInput& input, DynamicInstances& instances) {
    if (!input.rain && !input.weather)
        return;
    LIMEN_ASSERT(isFinite(input.eye), "weather falls around a finite eye");
    if (input.rain && instances.world().rainDrop != kNone)
        addRain(input, instances);
    if (!input.weather)
        return;
    for (const world::SkyWeather& weather : instances.world().sky.weather) {
        if (weather.dayGroup != input.weather->dayGroup ||
            !world::isShown(weather.object, input.weather->time))
            continue;
        const double radius = std::max(weather.spread.x, weather.spread.y);
        if (radius < kLeastSpread)
            addEmitter(input, {weather, input.eye, 0.0, weather.source.seed}, instances);
        else
            addSquares(input, weather, radius, instances);
    }
}

} // namespace limen::motion
