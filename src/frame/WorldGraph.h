#pragma once

#include "visibility/Graph.h"
#include "world/World.h"

namespace limen::frame {

/// The world's spaces and portals as a graph for the flood; space and portal numbers are the world's. Errors:
/// those of visibility::Graph::build.
[[nodiscard]] Result<visibility::Graph> visibilityGraph(const world::World& world);

} // namespace limen::frame
