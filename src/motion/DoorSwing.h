#pragma once

#include "motion/Body.h"

namespace limen::motion {

/// Swings one door to the openness `to`, 0..1. `doors` holds the openness of each of World::doors. The leaves
/// push the body along walls and never into them. Where the body cannot give way the door stops, and it does
/// not shut on a body in the opening. Changes doors[door] and `body` alone; does not allocate.
void swing(std::uint32_t door, double to, std::span<double> doors, BodyState& body, const Collisions& around,
           const BodyShape& shape = {});

/// Swings all doors from one openness to another. Returns the openness of the door that the body stops first;
/// without one, `to`. `doors`: scratch memory.
[[nodiscard]] double swingAll(double from, double to, BodyState& body, const Collisions& around,
                              std::vector<double>& doors, const BodyShape& shape = {});

} // namespace limen::motion
