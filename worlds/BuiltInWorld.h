#pragma once

#include "worlds/Materials.h"
#include "worlds/WorldRecords.h"

namespace limen::worlds {

/// The built-in world as records. The same every time. Cost: a second or two, nearly all of it painting.
[[nodiscard]] WorldRecords buildBuiltInWorld(Pictures pictures = Pictures::Painted);

} // namespace limen::worlds
