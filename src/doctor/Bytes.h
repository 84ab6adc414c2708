#pragma once

#include <cstdint>
#include <string>

namespace limen::doctor {

/// A number of bytes for people, e.g. "1.5 GiB".
[[nodiscard]] std::string bytesText(std::uint64_t bytes);

} // namespace limen::doctor
