#include "engine/UserFiles.h"

#include <array>
#include <cstdlib>
#include <system_error>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;

/// $`variable`, else $HOME/`inHome`, with "limen" added.
fs::path userDirectory(const char* variable, const char* inHome) {
    const auto absolute = [](const char* name) -> fs::path {
        const char* value = std::getenv(name);
        const fs::path path = value != nullptr ? value : "";
        return path.is_absolute() ? path : fs::path();
    };
    if (const fs::path directory = absolute(variable); !directory.empty())
        return directory / "limen";
    if (const fs::path home = absolute("HOME"); !home.empty())
        return home / inHome / "limen";
    return {};
}

} // namespace

fs::path cacheRoot() {
    return userDirectory("XDG_CACHE_HOME", ".cache");
}

fs::path configurationRoot() {
    return userDirectory("XDG_CONFIG_HOME", ".config");
}

fs::path programPath() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error);
}

std::vector<fs::path> fontPaths(const fs::path& program) {
    constexpr std::array kNames{"DejaVuSans.ttf", "NotoSans-Regular.ttf", "LiberationSans-Regular.ttf"};
    std::vector<fs::path> paths;
    const fs::path beside = program.parent_path();
    for (const fs::path& directory : {beside, beside / "fonts", beside / ".." / "share" / "limen"})
        if (!program.empty())
            paths.push_back(directory / kNames[0]);
    for (const char* directory : {"dejavu", "noto", "liberation", "liberation2", "."})
        for (const char* name : kNames)
            for (const char* root :
                 {"/usr/share/fonts/truetype", "/usr/local/share/fonts", "/usr/share/fonts"})
                paths.push_back(fs::path(root) / directory / name);
    return paths;
}

std::optional<fs::path> findFont(const std::vector<fs::path>& paths) {
    std::error_code error;
    for (const fs::path& path : paths)
        if (fs::is_regular_file(path, error))
            return path;
    return std::nullopt;
}

} // namespace limen::engine
