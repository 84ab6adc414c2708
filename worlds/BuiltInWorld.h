#pragma once

#include "worlds/records/Materials.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// The built-in world as records; every call gives the same ones. Cost: one to two seconds, nearly all of it
/// painting.
[[nodiscard]] WorldRecords buildBuiltInWorld(Pictures pictures = Pictures::Painted);

} // namespace limen::worlds
