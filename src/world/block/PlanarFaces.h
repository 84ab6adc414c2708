#pragma once

#include "geometry/Vec.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace limen::world {

/// The bounded faces of a plane graph, counter-clockwise, as lists of vertices. `edges`: each once; they meet at their ends
/// only. A part of the graph that touches no other adds a face of its own, and no hole to the face around it.
[[nodiscard]] std::vector<std::vector<std::uint32_t>>
boundedFaces(std::span<const Vec2> points, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges);

/// Square metres of a polygon of numbered points; negative if it is clockwise.
[[nodiscard]] double signedArea(std::span<const Vec2> points, std::span<const std::uint32_t> loop);

} // namespace limen::world
