#include "core/platform/Environment.h"

#include <algorithm>
#include <cstdlib>
#include <unistd.h>

namespace limen::platform {

namespace fs = std::filesystem;

std::string environmentVariable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

fs::path homeDirectory() {
    return environmentVariable("HOME");
}

bool hasDesktop() {
    return !environmentVariable("DISPLAY").empty() || !environmentVariable("WAYLAND_DISPLAY").empty();
}

std::vector<fs::path> driveRoots() {
    return {};
}

std::vector<fs::path> directoriesOf(std::string_view searchPath) {
    std::vector<fs::path> directories;
    for (std::size_t begin = 0; begin <= searchPath.size();) {
        const std::size_t end = std::min(searchPath.find(':', begin), searchPath.size());
        fs::path directory = searchPath.substr(begin, end - begin);
        if (directory.is_absolute())
            directories.push_back(std::move(directory));
        begin = end + 1;
    }
    return directories;
}

std::string programFileName(std::string_view name) {
    return std::string(name);
}

bool isProgram(const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

} // namespace limen::platform
