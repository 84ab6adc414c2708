#pragma once

#include "frames/FrameWay.h"

#include <filesystem>

namespace limen::bench {

/// Writes the colours of a picture as a PNG. Errors: Unreadable.
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& file, const FramePicture& picture);

} // namespace limen::bench
