#pragma once

#include "core/Error.h"
#include "world/Image.h"

#include <span>

namespace limen::world {

/// Decodes a JFIF file; alpha is 255. Errors: bytes that are none, or damaged; dimensions out of 1..`largest`;
/// Unsupported: colour spaces other than grey and YCbCr.
[[nodiscard]] Result<Image> decodeJpeg(std::span<const std::uint8_t> bytes, int largest);

} // namespace limen::world
