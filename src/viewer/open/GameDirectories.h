#pragma once

#include <filesystem>
#include <vector>

namespace limen::viewer {

/// Existing directories in which installers of the game put its files, for the Open page.
[[nodiscard]] std::vector<std::filesystem::path> gameDirectories();

} // namespace limen::viewer
