#pragma once

#include "world/World.h"

namespace limen::worlds::test {

/// The built-in world as a program loads it, around the village, with all that moves; its files are gone afterwards.
[[nodiscard]] const world::World& loaded();

} // namespace limen::worlds::test
