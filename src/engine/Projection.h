#pragma once

#include "visibility/View.h"

#include <optional>
#include <utility>

namespace limen::engine {

/// Projects the part of a line (global, metres) that is at least 2 cm ahead, to NDC. Its ends can be outside
/// of the picture. None: the whole line is behind the eye.
[[nodiscard]] std::optional<std::pair<Vec2, Vec2>> projectLine(const Vec3& a, const Vec3& b,
                                                               const visibility::View& eye);

} // namespace limen::engine
