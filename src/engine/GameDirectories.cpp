#include "engine/DatDirectory.h"

#include "core/platform/Environment.h"
#include "core/platform/Files.h"

#include <algorithm>
#include <array>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

constexpr std::array kInstallPaths{
    "Turbine/Asheron's Call",
    "Turbine/Asheron's Call - Throne of Destiny",
    "Asheron's Call",
    "Microsoft Games/Asheron's Call",
};
constexpr std::array kProgramFolders{"Program Files (x86)", "Program Files", "ProgramData", "Games", ""};

/// The game's directories on one drive, by likelihood.
Paths onDrive(const fs::path& drive) {
    Paths paths;
    for (const char* folder : kProgramFolders)
        for (const char* install : kInstallPaths)
            paths.push_back((*folder == '\0' ? drive : drive / folder) / install);
    for (const char* shortName : {"AC", "Games/AC"})
        paths.push_back(drive / shortName);
    return paths;
}

/// Directories whose entries are Wine prefixes.
Paths prefixCollections(const fs::path& home, const fs::path& data) {
    return {data / "wineprefixes",
            home / "Games", // Lutris
            home / ".var/app/net.lutris.Lutris/data/lutris/prefixes",
            data / "bottles/bottles",
            home / ".var/app/com.usebottles.bottles/data/bottles/bottles",
            home / ".PlayOnLinux/wineprefix",
            data / "Steam/steamapps/compatdata",
            home / ".steam/steam/steamapps/compatdata"};
}

Paths winePrefixes(const SystemView& system) {
    Paths prefixes;
    if (const std::string prefix = system.environment("WINEPREFIX"); !prefix.empty())
        prefixes.emplace_back(prefix);
    if (system.home.empty())
        return prefixes;
    prefixes.push_back(system.home / ".wine");
    const std::string set = system.environment("XDG_DATA_HOME");
    const fs::path data = set.empty() ? system.home / ".local/share" : fs::path(set);
    for (const fs::path& collection : prefixCollections(system.home, data))
        for (const fs::path& entry : system.entries(collection))
            prefixes.push_back(entry);
    return prefixes;
}

} // namespace

Paths knownGameDirectories(const SystemView& system) {
    Paths found;
    const auto consider = [&](const fs::path& path) {
        if (std::find(found.begin(), found.end(), path) == found.end() && system.exists(path))
            found.push_back(path);
    };
    for (const char* variable : {"ProgramFiles(x86)", "ProgramFiles"})
        if (const std::string folder = system.environment(variable); !folder.empty())
            for (const char* install : kInstallPaths)
                consider(fs::path(folder) / install);
    for (const fs::path& drive : system.drives)
        for (const fs::path& path : onDrive(drive))
            consider(path);
    for (const fs::path& prefix : winePrefixes(system))
        for (const char* drive : {"drive_c", "pfx/drive_c"}) // Steam keeps its prefix in pfx
            if (system.exists(prefix / drive))
                for (const fs::path& path : onDrive(prefix / drive))
                    consider(path);
    if (!system.home.empty())
        for (const char* folder :
             {"Asheron's Call", "asheronscall", "ac", "Games/Asheron's Call", "games/ac"})
            consider(system.home / folder);
    return found;
}

Paths knownGameDirectories() {
    const auto entries = [](const fs::path& directory) {
        Paths paths;
        std::error_code error;
        for (fs::directory_iterator it(directory, error), end; !error && it != end; it.increment(error))
            if (platform::isText(it->path()))
                paths.push_back(it->path());
        std::sort(paths.begin(), paths.end());
        return paths;
    };
    const auto exists = [](const fs::path& path) {
        std::error_code error;
        return fs::is_directory(path, error);
    };
    return knownGameDirectories(SystemView{platform::homeDirectory(), platform::environmentVariable, entries,
                                           exists, platform::driveRoots()});
}

} // namespace limen::engine
