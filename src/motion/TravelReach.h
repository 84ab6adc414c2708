#pragma once

#include "world/World.h"

#include <optional>

namespace limen::motion {

/// The travel portal that a player would use: an index into World::placed. Among those within 3 m of the eye, the one nearest
/// to the gaze; at most 60 degrees from it. `forward`: unit vector.
[[nodiscard]] std::optional<std::size_t> travelInReach(const world::World& world, const Vec3& eye,
                                                       const Vec3& forward);

} // namespace limen::motion
