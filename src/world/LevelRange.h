#pragma once

#include "geometry/Vec.h"

#include <cstdint>

// From how far away things are drawn: levels of detail. Distances are of the eye from an instance's origin, both rounded down to
// sixteenths of a metre, and compared in whole numbers: so the device and the reference decide alike to the bit, where floats would
// show another thing whole to an eye within a rounding of the limit.
namespace limen::world {

inline constexpr std::int32_t kRangeSteps = 16; ///< a metre
inline constexpr std::int32_t kMostRangeSteps =
    37000; ///< farther counts as so far, each way: squares of three fit in 32 bits
inline constexpr std::int32_t kMostLocalSteps = 1 << 20; ///< likewise of an origin from its block's

/// An instance is drawn if the eye is farther than `beyond`, and not farther than `upTo`.
struct LevelRange {
    static constexpr std::uint16_t kEndless = 0xFFFF;
    std::uint16_t beyond = 0;      ///< steps, at most kMostRangeSteps; 0: from the origin itself on
    std::uint16_t upTo = kEndless; ///< likewise
    [[nodiscard]] bool isEndless() const { return beyond == 0 && upTo == kEndless; }
    friend bool operator==(const LevelRange&, const LevelRange&) = default;
};

/// The limit next to a distance in metres; beyond what can be told apart: none.
[[nodiscard]] std::uint16_t levelRangeLimit(double metres);

/// A global position in steps.
struct RangeSteps {
    std::int64_t x = 0, y = 0, z = 0;
};
[[nodiscard]] RangeSteps rangeStepsOf(const Vec3& global);

struct World;
struct Instance;

/// Whether the eye is where the instance is drawn from. Requires a block.
[[nodiscard]] bool isInLevelRange(const World& world, const Instance& instance, const RangeSteps& eye);

} // namespace limen::world
