#pragma once

#include "gpu/RenderOptions.h"
#include "gpu/device/Device.h"

namespace limen::gpu {

/// Whether a frame draws a program's batches. Flat ones show ids, and neither what is blended nor what floats in the sky has
/// one; frames that count layers paint nothing blended.
[[nodiscard]] bool isDrawn(frame::Program program, const RenderOptions& options);

/// Which images a program writes.
[[nodiscard]] Pass passOf(frame::Program program, const RenderOptions& options);

} // namespace limen::gpu
