#pragma once

#include "cli/help/CommandFacts.h"

namespace limen::cli {

/// The manual page of a command in roff with the macros of man(7). `root`: the program, for the list of pages
/// at the end. `version`: "0.1.0".
[[nodiscard]] std::string manPage(const CommandFacts& command, const CommandFacts& root,
                                  const std::string& version);

} // namespace limen::cli
