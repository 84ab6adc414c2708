#include "engine/UserFiles.h"

#include "core/platform/Environment.h"

namespace limen::engine {
namespace {

namespace fs = std::filesystem;

constexpr UserDirectoryNames kVariables{"LOCALAPPDATA", "APPDATA", "LOCALAPPDATA", "APPDATA"};

fs::path inVariable(const char* variable, const char* folder) {
    const fs::path path = platform::environmentVariable(variable);
    return path.is_absolute() ? path / folder : fs::path();
}

} // namespace

fs::path cacheRoot() {
    const fs::path ours = inVariable(kVariables.cache, "limen");
    return ours.empty() ? ours : ours / "cache";
}

fs::path configurationRoot() {
    return inVariable(kVariables.configuration, "limen");
}

UserDirectoryNames userDirectoryNames() {
    return kVariables;
}

const char* gameDirectoryExample() {
    return "\"C:\\Turbine\\Asheron's Call\"";
}

std::vector<fs::path> fontPaths(const fs::path& program) {
    std::vector<fs::path> paths;
    const fs::path beside = program.parent_path();
    for (const fs::path& directory : {beside / "fonts", beside})
        if (!program.empty())
            paths.push_back(directory / "DejaVuSans.ttf");
    if (const fs::path system = inVariable("SystemRoot", "Fonts"); !system.empty())
        for (const char* name : {"segoeui.ttf", "arial.ttf"})
            paths.push_back(system / name);
    return paths;
}

} // namespace limen::engine
