#pragma once

#include "output/Picture.h"

#include <filesystem>
#include <string>

namespace limen::viewer {

/// Saves a picture as limen-NNNN.png with the next free number; never overwrites a file. limen-NNNN.txt holds
/// the command that draws the picture again: `command` with an output option. Returns the picture's path.
/// Errors: a directory that is missing or cannot be written to; a full disk.
[[nodiscard]] Result<std::filesystem::path> keepScreenshot(const std::filesystem::path& directory,
                                                           const output::Picture& picture,
                                                           const std::string& command);

} // namespace limen::viewer
