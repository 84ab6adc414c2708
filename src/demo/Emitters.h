#pragma once

#include "demo/Places.h"

namespace limen::demo {

/// The emitters of `world.json`: smoke, fires, torches, fireflies, a swirl in the open, the watchman's lantern.
[[nodiscard]] nlohmann::ordered_json buildEmitters(const VillageMap& map);

} // namespace limen::demo
