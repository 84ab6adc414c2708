#pragma once

#include "geometry/Vec.h"

namespace limen {

/// A position as two floats: the nearest float, and the rest. For positions that the GPU needs more exactly
/// than a float: at 192 m one float is exact to 0.008 mm, two are as exact as a double.
struct TwoFloats {
    Vec3f nearest{0.0f}, rest{0.0f};

    /// Their sum, exact in double.
    [[nodiscard]] Vec3 sum() const { return Vec3(nearest) + Vec3(rest); }
};

/// The nearest vector whose components fit a float, still as doubles. Ref: Dekker, "A floating-point technique
/// for extending the available precision" (1971), Veltkamp's splitting.
[[nodiscard]] inline Vec3 roundedToFloats(const Vec3& v) {
    constexpr double kSplit = 536870913.0; // 2^29 + 1: leaves 24 of 53 bits
    const Vec3 scaled = v * kSplit;
    return scaled - (scaled - v);
}

/// Equal positions have equal parts, to the bit. The sum is the position if that has at most 24 bits below
/// the last bit of its float. Does not round by converting to float and back: GCC 12 optimises that away where
/// it vectorises.
[[nodiscard]] inline TwoFloats inTwoFloats(const Vec3& position) {
    const Vec3 nearest = roundedToFloats(position);
    return {Vec3f(nearest), Vec3f(roundedToFloats(position - nearest))};
}

} // namespace limen
