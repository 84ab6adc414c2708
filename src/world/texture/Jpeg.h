#pragma once

#include "core/Error.h"
#include "world/Image.h"

#include <span>

namespace limen::world {

/// Decodes a JFIF file; alpha is 255. Errors: Malformed for other or damaged bytes and for dimensions out of
/// 1..`largest`; Unsupported for colour spaces other than grey and YCbCr.
[[nodiscard]] Result<Image> decodeJpeg(std::span<const std::uint8_t> bytes, int largest);

} // namespace limen::world
