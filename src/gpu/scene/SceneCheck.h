#pragma once

#include "core/Error.h"
#include "frame/SceneUpload.h"

namespace limen::gpu {

/// Every index that a shader follows in static data leads somewhere: a wrong one would make the GPU read
/// astray, which no driver reports. Errors: BadArgument, naming the array, the entry and the index. Cost:
/// linear.
[[nodiscard]] Result<void> checkScene(const frame::SceneUpload& scene);

} // namespace limen::gpu
