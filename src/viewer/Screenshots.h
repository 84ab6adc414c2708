#pragma once

#include "output/Picture.h"

#include <filesystem>
#include <string>

namespace limen::viewer {

/// Keeps a picture in the directory as limen-0001.png, or with the number after the largest that is there; nothing is ever written
/// over. Beside it limen-0001.txt, a line: `command` with the option that names its output, which draws the picture again. Yields the
/// picture's path. Errors: the directory is missing or cannot be written to; a full disk.
[[nodiscard]] Result<std::filesystem::path> keepScreenshot(const std::filesystem::path& directory,
                                                           const output::Picture& picture,
                                                           const std::string& command);

} // namespace limen::viewer
