#pragma once

#include <utility>
#include <vector>

namespace limen::worlds {

/// The stream: from the western border through the valley south of the village, then out by a gorge in the southern
/// hills. Vertices of the ground (TerrainShape); consecutive ones share an edge, so that pictures of the ground join to
/// one band of water.
[[nodiscard]] const std::vector<std::pair<int, int>>& streamPath();

/// Distance to the stream's nearest vertex, in vertices.
[[nodiscard]] double distanceToStream(double vx, double vy);

/// The height (metres) of ground that the stream has cut into: its bed, which never rises downstream, banks beside it,
/// slopes up to the `height` of the land.
[[nodiscard]] double cutByStream(double height, double vx, double vy);

} // namespace limen::worlds
