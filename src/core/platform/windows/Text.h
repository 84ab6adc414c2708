#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limen::platform {

/// UTF-8 to UTF-16 and back. Malformed parts become U+FFFD.
[[nodiscard]] std::wstring wideText(std::string_view text);
[[nodiscard]] std::string narrowText(std::wstring_view text);

/// True if each half of a surrogate pair has its other half.
[[nodiscard]] bool isWellFormed(std::wstring_view text);

/// The text of a Win32 error, without its line end.
[[nodiscard]] std::string errorText(unsigned long error);

/// Arguments as one command line, quoted for CommandLineToArgvW.
[[nodiscard]] std::wstring commandLine(const std::vector<std::string>& arguments);

} // namespace limen::platform
