#pragma once

#include <filesystem>

namespace limen {

/// The path from the root. An empty path is the working directory, also on Windows, where std::filesystem::absolute refuses it.
/// Returns the path itself if the system does not report the working directory.
[[nodiscard]] std::filesystem::path absolutePath(const std::filesystem::path& path);

} // namespace limen
