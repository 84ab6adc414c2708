#pragma once

#include <string>
#include <string_view>

namespace limen::placements {

/// A text with each byte that is no part of valid UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string validUtf8(std::string_view text);

/// The same for messages: control characters are replaced by blanks, too.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace limen::placements
