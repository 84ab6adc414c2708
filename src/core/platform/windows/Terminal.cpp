#include "core/platform/Terminal.h"

#include <io.h>
#include <windows.h>

namespace limen::platform {

/// Only a console: _isatty is also true for other devices.
bool isTerminal(std::FILE* file) {
    DWORD mode = 0;
    return GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(file))), &mode) != 0;
}

std::optional<std::size_t> terminalWidth() {
    CONSOLE_SCREEN_BUFFER_INFO info{};
    if (GetConsoleScreenBufferInfo(GetStdHandle(STD_OUTPUT_HANDLE), &info) == 0)
        return {};
    return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

} // namespace limen::platform
