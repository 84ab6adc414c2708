#pragma once

#include "core/Error.h"
#include "dat/records/Landscape.h"

#include <cstdint>
#include <string>

namespace limen::engine {

/// The day group that --day names; empty: the first. Errors: there is none such (those that there are, are in the message).
[[nodiscard]] Result<std::uint32_t> dayGroupOf(const dat::SkyDesc& sky, const std::string& text);

/// What people choose it by: its name, and its number where others have the same or it has none.
[[nodiscard]] std::string dayGroupLabel(const dat::SkyDesc& sky, std::uint32_t group);

} // namespace limen::engine
