#pragma once

#include <cstdint>
#include <string>

// Numbers as text for people.
namespace limen {

/// A number with its digits in groups, e.g. "805,348".
[[nodiscard]] std::string groupedText(std::uint64_t number);

} // namespace limen
