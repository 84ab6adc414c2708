#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

// Checks of option values. Unlike CLI11's own, they suggest the nearest value and leave the help text alone.
namespace limen::cli {

/// ". Did you mean 'shot'?" for the nearest of `candidates`, else "; choose from a, b".
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

/// Accepts these values only. The values also belong into the option's type name, as "a|b", from which help,
/// manual and completions read them.
[[nodiscard]] CLI::Validator oneOf(std::vector<std::string> values);

/// Accepts numbers from `low` to `high`, both included.
[[nodiscard]] CLI::Validator within(double low, double high);

/// Refuses an empty text, which in scripts is usually an unset variable.
[[nodiscard]] CLI::Validator notEmpty();

} // namespace limen::cli
