#pragma once

#include "demo/WorldRecords.h"

namespace limen::demo {

/// The built-in world as records. The same every time. Cost: a second or two, nearly all of it painting.
[[nodiscard]] WorldRecords buildBuiltInWorld();

} // namespace limen::demo
