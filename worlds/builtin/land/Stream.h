#pragma once

#include <utility>
#include <vector>

namespace limen::worlds {

/// The stream from the western border through the valley south of the village to a gorge in the southern
/// hills, as vertices of the ground (TerrainShape). Consecutive ones share an edge, so that ground pictures
/// form one band of water.
[[nodiscard]] const std::vector<std::pair<int, int>>& streamPath();

/// The distance to the stream's nearest vertex, in vertices.
[[nodiscard]] double distanceToStream(double vx, double vy);

/// The height (metres) of the ground with the stream's valley: a bed that never rises downstream, low banks beside it (the
/// picture of water climbs half of them), then slopes up to `height`.
[[nodiscard]] double cutByStream(double height, double vx, double vy);

} // namespace limen::worlds
