#include "core/platform/Terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

namespace limen::platform {

bool isTerminal(std::FILE* file) {
    return ::isatty(::fileno(file)) == 1;
}

std::optional<std::size_t> terminalWidth() {
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return {};
    return size.ws_col;
}

} // namespace limen::platform
