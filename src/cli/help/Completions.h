#pragma once

#include "cli/help/CommandFacts.h"

#include <span>

// Completions for shells. They know verbs, options, fixed values, files, directories and places.
namespace limen::cli {

/// A script for bash; source it. `places`: names for options whose value is a PLACE.
[[nodiscard]] std::string bashCompletions(const CommandFacts& root, std::span<const std::string> places);

/// A file for zsh, to be called _limen in a directory of fpath; it can be sourced, too.
[[nodiscard]] std::string zshCompletions(const CommandFacts& root, std::span<const std::string> places);

} // namespace limen::cli
