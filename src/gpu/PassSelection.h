#pragma once

#include "gpu/RenderOptions.h"
#include "gpu/device/Device.h"

namespace limen::gpu {

/// Whether a frame draws a program's batches. Flat frames show ids, which blended surfaces and sky objects
/// lack. Frames that count layers paint nothing blended.
[[nodiscard]] bool isDrawn(frame::Program program, const RenderOptions& options);

/// The images that a program writes.
[[nodiscard]] Pass passOf(frame::Program program, const RenderOptions& options);

} // namespace limen::gpu
