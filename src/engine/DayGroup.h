#pragma once

#include "core/Error.h"
#include "world/Calendar.h"

#include <cstdint>
#include <string>

namespace limen::engine {

/// The choice of a day group.
struct DayChoice {
    std::string day;  ///< a number or a name (--day); empty: that of the date
    world::Date date; ///< --date
};
/// The index of the chosen day group. Errors: NotFound, with the labels of all day groups.
[[nodiscard]] Result<std::uint32_t> dayGroupOf(const dat::SkyDesc& sky, const dat::GameTime& calendar,
                                               const DayChoice& choice);

/// The label of a day group in lists: its name. Its number is added if several groups share the name, and
/// replaces a missing name. Requires a valid index.
[[nodiscard]] std::string dayGroupLabel(const dat::SkyDesc& sky, std::uint32_t group);

} // namespace limen::engine
