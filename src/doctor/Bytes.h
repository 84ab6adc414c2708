#pragma once

#include <cstdint>
#include <string>

namespace limen::doctor {

/// A number of bytes for people, e.g. "1.5 GiB".
[[nodiscard]] std::string bytesText(std::uint64_t bytes);
/// A number with its digits in groups, e.g. "805,348".
[[nodiscard]] std::string groupedText(std::uint64_t number);

} // namespace limen::doctor
