#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Names that a user may have meant.
namespace limen {

/// The name in lower case (ASCII) without spaces, hyphens, apostrophes, underscores and dots, so that
/// "al-arqas" and "Al Arqas" are equal.
[[nodiscard]] std::string plainName(std::string_view name);

/// The fewest single-letter changes that turn `a` into `b`: insert, delete, replace, swap of neighbours.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

/// Up to `most` candidates that resemble `name`, the most similar first, equal ones in their given order.
/// Compares plain names. A candidate resembles a name if at most a third of the letters (at least one)
/// differ, or if one begins with or contains the other.
[[nodiscard]] std::vector<std::string> nearest(std::string_view name, std::span<const std::string> candidates,
                                               std::size_t most = 3);

/// " Did you mean 'a', 'b' or 'c'?" with a leading blank; empty without names.
[[nodiscard]] std::string didYouMean(std::span<const std::string> names);

} // namespace limen
