#pragma once

#include <filesystem>
#include <optional>
#include <vector>

// Files and directories of the user and of the system, found from the environment.
namespace limen::engine {

/// $XDG_CACHE_HOME, else $HOME/.cache, with "limen" added; on Windows limen/cache in %LOCALAPPDATA%. Empty if the variables are
/// no absolute paths.
[[nodiscard]] std::filesystem::path cacheRoot();
/// The directory of the user's settings: $XDG_CONFIG_HOME, else $HOME/.config, with "limen" added; on Windows
/// limen in %APPDATA%. Empty if the variables are no absolute paths.
[[nodiscard]] std::filesystem::path configurationRoot();

/// The environment variables that choose these directories.
struct UserDirectoryNames {
    const char* cache;
    const char* configuration;
    const char* cacheFallback; ///< the variable that counts if `cache` is not set
    const char* configurationFallback;
};
[[nodiscard]] UserDirectoryNames userDirectoryNames();

/// A directory of the game as an example in messages, in quotation marks.
[[nodiscard]] const char* gameDirectoryExample();

/// Paths at which the window's font is searched: beside the program first, then in the system's directories (on Linux
/// those of Debian's packages).
[[nodiscard]] std::vector<std::filesystem::path> fontPaths(const std::filesystem::path& program);
/// The first of these files that exists.
[[nodiscard]] std::optional<std::filesystem::path> findFont(const std::vector<std::filesystem::path>& paths);

} // namespace limen::engine
