#pragma once

#include "core/Error.h"
#include "world/Readings.h"

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace limen::cli {

/// "NAME=VALUE,...", such as "sky-place=block,wall-grey=0.5"; blanks around names and values are allowed. Errors: an
/// unknown name or value; a name given twice.
[[nodiscard]] Result<world::Readings> parseReadings(std::string_view text);

/// All names with their values: "sky-place=eye|block|cell, ...".
[[nodiscard]] std::string readingsNotation();

/// Adds --readings.
void addReadings(CLI::App& command, world::Readings& readings);

} // namespace limen::cli
