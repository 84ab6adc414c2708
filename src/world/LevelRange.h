#pragma once

#include "geometry/Vec.h"

#include <cstdint>

// Levels of detail by distance. The distance is that of the eye from an instance's origin, both rounded down
// to 1/16 m and compared as integers. So the device and the reference always decide alike. With floats, an
// eye within a rounding error of the limit would see another mesh.
namespace limen::world {

inline constexpr std::int32_t kRangeSteps = 16; ///< per metre
/// Distances along each axis are clamped to this: the sum of three squares fits in 32 bits.
inline constexpr std::int32_t kMostRangeSteps = 37000;
inline constexpr std::int32_t kMostLocalSteps = 1 << 20; ///< block-local origins are clamped to this

/// An instance is drawn if the eye is farther than `beyond` and not farther than `upTo`.
struct LevelRange {
    static constexpr std::uint16_t kEndless = 0xFFFF;
    std::uint16_t beyond = 0;      ///< steps, at most kMostRangeSteps; 0: the range includes the origin
    std::uint16_t upTo = kEndless; ///< steps, at most kMostRangeSteps; kEndless: every distance
    [[nodiscard]] bool isEndless() const { return beyond == 0 && upTo == kEndless; }
    friend bool operator==(const LevelRange&, const LevelRange&) = default;
};

/// A distance in metres, rounded to steps; kEndless beyond kMostRangeSteps and for NaN.
[[nodiscard]] std::uint16_t levelRangeLimit(double metres);

/// A global position in steps.
struct RangeSteps {
    std::int64_t x = 0, y = 0, z = 0;
};
[[nodiscard]] RangeSteps rangeStepsOf(const Vec3& global);

struct World;
struct Instance;

/// True if the eye's distance is in the instance's range. Requires: the instance has a block.
[[nodiscard]] bool isInLevelRange(const World& world, const Instance& instance, const RangeSteps& eye);

} // namespace limen::world
