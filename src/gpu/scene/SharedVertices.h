#pragma once

#include "frame/GpuLayout.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limen::gpu {

/// The same triangles with fewer vertices: each index is of the first vertex that Drawing::Fast cannot tell
/// from the original one (same position, normal, texture coordinates and surface). The polygon and the plane,
/// which differ between the triangles around a corner, are those of the first triangle. fast.vert reads the plane of panes, which are
/// flat. One index per index, in the same order.
/// Requires valid indices. Cost: linear.
[[nodiscard]] std::vector<std::uint32_t> shareVertices(std::span<const frame::gpu::Vertex> vertices,
                                                       std::span<const std::uint32_t> indices);

} // namespace limen::gpu
