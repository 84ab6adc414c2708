#pragma once

#include "world/World.h"

namespace limen::worlds::test {

/// The loaded world around the village, with all moving objects. Its files are removed.
[[nodiscard]] const world::World& loaded();

} // namespace limen::worlds::test
