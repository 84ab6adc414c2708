#pragma once

#include "core/Error.h"
#include "dat/records/Landscape.h"

#include <cstdint>
#include <string>

namespace limen::engine {

/// The index of the day group that `text` (--day) names or numbers; empty: the first. Errors: NotFound, with
/// the labels of all day groups.
[[nodiscard]] Result<std::uint32_t> dayGroupOf(const dat::SkyDesc& sky, const std::string& text);

/// The label of a day group in lists: its name. Its number is added if several groups share the name, and
/// replaces a missing name. Requires a valid index.
[[nodiscard]] std::string dayGroupLabel(const dat::SkyDesc& sky, std::uint32_t group);

} // namespace limen::engine
