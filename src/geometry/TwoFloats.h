#pragma once

#include "geometry/Vec.h"

namespace limen {

/// A position in two floats: the nearest one, and the rest that it leaves. For what a float alone rounds too coarsely and the
/// GPU shall have as fine: 192 m in one float is good to 0.008 mm, in two to what a double is good for.
struct TwoFloats {
    Vec3f nearest{0.0f}, rest{0.0f};

    /// Their sum, which a double holds.
    [[nodiscard]] Vec3 sum() const { return Vec3(nearest) + Vec3(rest); }
};

/// Equal positions have equal parts, to the bit. The sum is the position as long as that has no more than 24 bits below the
/// last one of its float. Not by way of a conversion to float and back: GCC 12 takes that for nothing where it vectorises.
/// Ref: Dekker, "A floating-point technique for extending the available precision" (1971), Veltkamp's splitting.
[[nodiscard]] inline TwoFloats inTwoFloats(const Vec3& position) {
    constexpr double kSplit = 536870913.0; // 2^29 + 1: leaves 24 of 53 bits
    const Vec3 scaled = position * kSplit;
    const Vec3 nearest = scaled - (scaled - position);
    return {Vec3f(nearest), Vec3f(position - nearest)};
}

} // namespace limen
