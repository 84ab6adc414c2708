#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <nlohmann/json.hpp>

namespace limen::worlds {

/// Height of an eye above the feet, metres.
inline constexpr double kEyeHeight = 1.7;

/// A viewpoint: global metres, degrees; `cell` 0 means outside.
struct Eye {
    Vec3 position{0.0};
    double yaw = 0.0, pitch = 0.0;
    dat::RecordId cell = 0;
};

/// Turns the eye towards a point; global metres.
void lookAt(Eye& eye, const Vec3& target);
/// An eye at a point that looks at `target`; global metres.
[[nodiscard]] Eye eyeTowards(const Vec3& position, const Vec3& target, dat::RecordId cell);
/// An eye at kEyeHeight above the ground at a point (metres of the area) that looks at `target` (global
/// metres).
[[nodiscard]] Eye groundEye(double x, double y, const Vec3& target);

/// A place of `world.json` (docs/world-file.md).
[[nodiscard]] nlohmann::ordered_json toJson(const Eye& eye);

} // namespace limen::worlds
