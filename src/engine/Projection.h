#pragma once

#include "visibility/View.h"

#include <optional>
#include <utility>

namespace limen::engine {

/// A line's part before the eye, in NDC; it may leave the picture. None: all of it lies behind.
[[nodiscard]] std::optional<std::pair<Vec2, Vec2>> projectLine(const Vec3& a, const Vec3& b,
                                                               const visibility::View& eye);

} // namespace limen::engine
