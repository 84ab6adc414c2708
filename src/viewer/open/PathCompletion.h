#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Completion of a directory that the user types.
namespace limen::viewer {

struct PathCompletion {
    std::string text;                 ///< the typed text, extended as far as all matches agree
    std::vector<std::string> matches; ///< paths of the directories that begin with the typed text, sorted
};

/// Lists the directories that complete `typed`. "~" at the beginning means `home`. Hidden directories are
/// listed only if their dot is typed. At most 200 matches.
[[nodiscard]] PathCompletion completeDirectory(const std::string& typed, const std::string& home);

/// `typed` without blanks at the ends and with "~" replaced by `home`.
[[nodiscard]] std::string expandHome(const std::string& typed, const std::string& home);

/// The directory above `typed`, with a slash at the end.
[[nodiscard]] std::string parentOf(const std::string& typed, const std::string& home);

/// Whether a directory holds files named as those of a world. Letters of either case count as equal.
[[nodiscard]] bool looksLikeWorld(const std::string& directory);

/// The directory to open for a path that was dropped onto the window: itself, or the directory of a file.
[[nodiscard]] std::string directoryOfDrop(const std::filesystem::path& path);

/// An absolute path without a slash at the end, so that one world has one name. Empty stays empty.
[[nodiscard]] std::string absoluteDirectory(const std::string& directory);

/// The name of a world for people. `directory` empty: the built-in world.
[[nodiscard]] std::string nameOfWorld(const std::string& directory);

} // namespace limen::viewer
