#pragma once

#include "motion/Body.h"

namespace limen::motion {

/// Swings one door to `to`, 0..1, from where `doors` (as in Collisions::sweep, but complete) says that it stands, and pushes a body before its leaves:
/// along walls and never into them. Where the body can give way no more the door stops, and it does not shut on one that stands in the
/// opening. Changes doors[door] and `body` alone; no allocation.
void swing(std::uint32_t door, double to, std::span<double> doors, BodyState& body, const Collisions& around,
           const BodyShape& shape = {});

/// Swings all doors alike, from one openness to another; as far as the body lets the first of them. `doors` is for scratch.
[[nodiscard]] double swingAll(double from, double to, BodyState& body, const Collisions& around,
                              std::vector<double>& doors, const BodyShape& shape = {});

} // namespace limen::motion
