#pragma once

#include "frames/FrameWay.h"

namespace limen::bench {

/// A scene graph of other makers that draws the places, in a context of its own: the world's triangles,
/// textures and levels of detail, culled by the frustum. Null where the peer is not built, because its
/// library is not installed (bench/README.md). Errors: Driver.
[[nodiscard]] Result<std::unique_ptr<FrameWay>> makePeerWay(std::uint32_t width, std::uint32_t height);

} // namespace limen::bench
