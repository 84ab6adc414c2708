#pragma once

#include "geometry/Vec.h"

#include <cmath>
#include <numbers>

namespace limen {

/// The rotation about +z from north (+y) to a compass direction; degrees, 90 is east (+x).
[[nodiscard]] inline Mat3 turnedTo(double yaw) {
    const double angle = -yaw * std::numbers::pi / 180.0;
    const double c = std::cos(angle), s = std::sin(angle);
    return {Vec3(c, s, 0.0), Vec3(-s, c, 0.0), Vec3(0.0, 0.0, 1.0)};
}

} // namespace limen
