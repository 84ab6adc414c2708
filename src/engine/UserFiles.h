#pragma once

#include <filesystem>
#include <optional>
#include <vector>

// Files and directories of the user and of the system, found from the environment.
namespace limen::engine {

/// $XDG_CACHE_HOME, else $HOME/.cache, with "limen" added. Empty if neither is an absolute path.
[[nodiscard]] std::filesystem::path cacheRoot();
/// The directory of the user's settings: $XDG_CONFIG_HOME, else $HOME/.config, with "limen" added. Empty if
/// neither is an absolute path.
[[nodiscard]] std::filesystem::path configurationRoot();

/// The path of the running program; empty if the system does not report it.
[[nodiscard]] std::filesystem::path programPath();
/// Paths at which the window's font is searched: beside the program first, then in the directories of Debian's
/// packages.
[[nodiscard]] std::vector<std::filesystem::path> fontPaths(const std::filesystem::path& program);
/// The first of these files that exists.
[[nodiscard]] std::optional<std::filesystem::path> findFont(const std::vector<std::filesystem::path>& paths);

} // namespace limen::engine
