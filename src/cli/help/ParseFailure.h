#pragma once

#include "core/Error.h"

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace limen::cli {

/// The chosen verb: "limen", "limen shot" or "limen dat ls". `program`: after parsing, also after a failure.
[[nodiscard]] const CLI::App& chosenCommand(const CLI::App& program);

/// The message for a command line that CLI11 refused, with the nearest verb or option, or with the help page
/// to read.
[[nodiscard]] Error parseFailure(const CLI::App& program, const CLI::ParseError& error);

} // namespace limen::cli
