#pragma once

#include "demo/Materials.h"
#include "demo/WorldRecords.h"

namespace limen::demo {

/// The built-in world as records. The same every time. Cost: a second or two, nearly all of it painting.
[[nodiscard]] WorldRecords buildBuiltInWorld(Pictures pictures = Pictures::Painted);

} // namespace limen::demo
