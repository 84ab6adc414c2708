#include "core/platform/Environment.h"

#include "core/platform/windows/Text.h"

#include <algorithm>
#include <cstdlib>
#include <windows.h>

namespace limen::platform {

namespace fs = std::filesystem;

std::string environmentVariable(const char* name) {
    const wchar_t* value = _wgetenv(wideText(name).c_str());
    return value != nullptr ? narrowText(value) : "";
}

fs::path homeDirectory() {
    return environmentVariable("USERPROFILE");
}

bool hasDesktop() {
    return true;
}

std::vector<fs::path> driveRoots() {
    std::vector<fs::path> roots;
    const DWORD drives = GetLogicalDrives();
    for (int letter = 0; letter < 26; ++letter) {
        const std::string root{static_cast<char>('A' + letter), ':', '/'};
        // Only disks: a drive without a medium would wait or ask for one.
        if ((drives >> letter & 1u) != 0 && GetDriveTypeW(wideText(root).c_str()) == DRIVE_FIXED)
            roots.emplace_back(root);
    }
    return roots;
}

std::vector<fs::path> directoriesOf(std::string_view searchPath) {
    std::vector<fs::path> directories;
    for (std::size_t begin = 0; begin <= searchPath.size();) {
        const std::size_t end = std::min(searchPath.find(';', begin), searchPath.size());
        std::string_view text = searchPath.substr(begin, end - begin);
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
            text = text.substr(1, text.size() - 2);
        fs::path directory = wideText(text);
        if (directory.is_absolute())
            directories.push_back(std::move(directory));
        begin = end + 1;
    }
    return directories;
}

std::string programFileName(std::string_view name) {
    return std::string(name) + ".exe";
}

bool isProgram(const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored);
}

} // namespace limen::platform
