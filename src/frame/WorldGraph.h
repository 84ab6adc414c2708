#pragma once

#include "visibility/Graph.h"
#include "world/World.h"

namespace limen::frame {

/// The zones of a graph: the world's, or each space a zone of its own, with the space's number.
enum class GraphZones : std::uint8_t { OfWorld, EachSpace };

/// The world's spaces and portals as a graph for the flood; space and portal numbers are the world's. Errors:
/// those of visibility::Graph::build.
[[nodiscard]] Result<visibility::Graph> visibilityGraph(const world::World& world,
                                                        GraphZones zones = GraphZones::OfWorld);

} // namespace limen::frame
