#include "engine/UserFiles.h"

#include "core/platform/Environment.h"

#include <array>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;

/// $`variable`, else $HOME/`inHome`, with "limen" added.
fs::path userDirectory(const char* variable, const char* inHome) {
    const auto absolute = [](const char* name) -> fs::path {
        const fs::path path = platform::environmentVariable(name);
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

UserDirectoryNames userDirectoryNames() {
    return {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "HOME", "HOME"};
}

const char* gameDirectoryExample() {
    return "\"$HOME/ac\"";
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

} // namespace limen::engine
