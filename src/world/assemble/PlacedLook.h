#pragma once

#include "world/PlacedEntry.h"
#include "world/records/Clothing.h"

namespace limen::world {

/// The look of a placed object: its body, its clothes, the changes of its own, and the things in its hands.
[[nodiscard]] Dress dressOf(const PlacedEntry& entry, Records& records);

} // namespace limen::world
