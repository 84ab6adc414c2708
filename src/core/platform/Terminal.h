#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>

namespace limen::platform {

[[nodiscard]] bool isTerminal(std::FILE* file);
/// The columns of the terminal of standard output; none: it is no terminal.
[[nodiscard]] std::optional<std::size_t> terminalWidth();

} // namespace limen::platform
