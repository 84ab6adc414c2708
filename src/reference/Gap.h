#pragma once

#include "geometry/Vec.h"

#include <span>

namespace limen::reference {

/// A ray that passes beside a polygon: at most kGapTolerance from its edge, measured in its plane. There is a gap if
/// another polygon is on the far side of the ray, within the same tolerance. Without one the ray is at the border of
/// a hole of any width, and meets nothing.
class Gap {
public:
    /// `passes`: where the ray meets the polygon's plane. `corners`: convex.
    Gap(const Vec3& passes, std::span<const Vec3> corners);
    /// The ray meets the edge itself up to rounding, so there is no other side.
    [[nodiscard]] bool isRounding() const;
    /// Whether a convex polygon, front or back, is the other side.
    [[nodiscard]] bool hasSide(std::span<const Vec3> corners) const;

private:
    Vec3 passes_{0.0}, across_{0.0}; ///< across: from the polygon to the ray
};

} // namespace limen::reference
