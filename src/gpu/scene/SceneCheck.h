#pragma once

#include "core/Error.h"
#include "frame/SceneUpload.h"

namespace limen::gpu {

/// Checks every index that a shader follows in static data. Drivers do not report an invalid one; the GPU
/// would read out of bounds.
/// Errors: BadArgument, naming the array, the entry and the index. Cost: linear.
[[nodiscard]] Result<void> checkScene(const frame::SceneUpload& scene);

} // namespace limen::gpu
