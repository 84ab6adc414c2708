#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace limen::platform {

/// The bytes of a line, e.g. "MemAvailable:", in the text of /proc/meminfo; none: the line is missing or malformed.
[[nodiscard]] std::optional<std::uint64_t> memoryIn(std::string_view meminfo, std::string_view name);

} // namespace limen::platform
