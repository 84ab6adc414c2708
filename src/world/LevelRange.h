#pragma once

#include "geometry/Vec.h"

#include <algorithm>
#include <array>
#include <cstdint>

// Levels of detail by distance (docs/ray-rule.md#levels-of-detail). Positions of the eye and of objects are
// rounded down to 1/16 m, and their distance is compared in integers. So the device and the reference always
// decide alike. With floats, an eye within a rounding error of the limit would see another mesh.
namespace limen::world {

inline constexpr std::int32_t kRangeSteps = 16; ///< per metre
/// Distances along each axis are clamped to this: the sum of three squares fits in 32 bits.
inline constexpr std::int32_t kMostRangeSteps = 37000;
inline constexpr std::int32_t kMostLocalSteps = 1 << 20; ///< block-local origins are clamped to this

inline constexpr double kDegradeDistance = 50.0; ///< metres that are subtracted from every distance
/// Metres, horizontally, beyond which everything in a landcell has the distance of the landcell's middle.
inline constexpr std::int32_t kLandcellBeyond = 50;

/// Distances from `from` up to, but not including, `upTo`.
struct LevelRange {
    static constexpr std::uint16_t kEndless = 0xFFFF;
    std::uint16_t from = 0;        ///< steps, at most kMostRangeSteps
    std::uint16_t upTo = kEndless; ///< steps, at most kMostRangeSteps; kEndless: every distance
    [[nodiscard]] bool isEndless() const { return from == 0 && upTo == kEndless; }
    /// `squared`: a squared distance in steps.
    [[nodiscard]] bool contains(std::uint32_t squared) const {
        const std::uint32_t least = from, limit = upTo;
        return squared >= least * least && (upTo == kEndless || squared < limit * limit);
    }
    friend bool operator==(const LevelRange&, const LevelRange&) = default;
};

/// A distance in metres, rounded to steps; kEndless beyond kMostRangeSteps and for NaN.
[[nodiscard]] std::uint16_t levelRangeLimit(double metres);

/// The share of their distances at which levels of detail change, for a picture with fewer pixels than its window: at half of
/// the width and height, everything looks as it does at twice the distance.
struct LevelShare {
    static constexpr std::uint32_t kWhole = 16;
    std::uint32_t sixteenths = kWhole; ///< 1..kWhole

    [[nodiscard]] double value() const { return static_cast<double>(sixteenths) / kWhole; }
    /// The squared distance to compare with a LevelRange, in steps.
    [[nodiscard]] std::uint32_t seen(std::uint32_t squared) const {
        const std::uint64_t farther = std::uint64_t{squared} * (kWhole * kWhole) / (sixteenths * sixteenths);
        return static_cast<std::uint32_t>(std::min<std::uint64_t>(farther, 0xFFFFFFFFu));
    }
    friend bool operator==(const LevelShare&, const LevelShare&) = default;
};
/// That of a picture of `percent` of its window's width and height, 1 to 100; rounded up.
[[nodiscard]] constexpr LevelShare levelShareOf(std::uint32_t percent) {
    return {std::clamp((percent * LevelShare::kWhole + 99) / 100, 1u, LevelShare::kWhole)};
}

/// A global position in steps.
struct RangeSteps {
    std::int64_t x = 0, y = 0, z = 0;
};
[[nodiscard]] RangeSteps rangeStepsOf(const Vec3& global);
/// A block-local position in steps, each clamped to kMostLocalSteps.
[[nodiscard]] std::array<std::int32_t, 3> localRangeSteps(const Vec3& local);

/// The distance by which a level is chosen.
enum class LevelMeasure : std::uint8_t {
    Object,   ///< from the eye to the object's origin
    Landcell, ///< horizontally to the middle of the object's landcell; within kLandcellBeyond as Object
};

/// The distances at which an instance is drawn: one level of detail of several.
struct Level {
    LevelRange range;
    LevelMeasure measure = LevelMeasure::Object;
    std::array<std::int32_t, 3> origin{}; ///< of the object, block-local steps
    friend bool operator==(const Level&, const Level&) = default;
};

/// Steps from the south-west corner of its landblock to the middle of the landcell at x or y.
[[nodiscard]] std::int32_t landcellMiddle(std::int32_t localSteps);

/// The eye relative to an object's origin or, where that counts, to the middle of its landcell: steps, z 0 for
/// the latter. `eye`: relative to the south-west corner of the block that `origin` is local to.
struct LevelDistance {
    std::uint32_t squared = 0; ///< steps
    bool isOfLandcell = false;
};
[[nodiscard]] LevelDistance levelDistance(LevelMeasure measure, const std::array<std::int32_t, 3>& origin,
                                          const RangeSteps& eye);

struct World;
struct Instance;

/// True if a static instance is drawn for this eye. Requires: the instance has a block.
[[nodiscard]] bool isInLevelRange(const World& world, const Instance& instance, const RangeSteps& eye,
                                  const LevelShare& share = {});

} // namespace limen::world
