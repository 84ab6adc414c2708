#pragma once

#include "world/Readings.h"

#include <string>
#include <vector>

namespace limen::frame {

/// The macros by which shaders follow readings of light and fog: "NAME" or "NAME VALUE". None for the defaults.
[[nodiscard]] std::vector<std::string> definesOf(const world::Readings& readings);

} // namespace limen::frame
