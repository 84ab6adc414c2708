#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <string>

// Map coordinates: docs/formats/landscape.md#map-coordinates.
namespace limen::engine {

inline constexpr double kMapUnitMetres = 240.0;
inline constexpr double kMapOriginMetres = 24468.0; ///< of both axes: the point 0N 0E

/// The landblock at a point of the map (global metres), within 0..254.
[[nodiscard]] dat::BlockCoord blockAtPoint(const Vec2& point);
/// Map coordinates of a point with one decimal: "42.1N 33.6E".
[[nodiscard]] std::string mapText(const Vec2& point);
/// The landblock as people write it: "A9B4".
[[nodiscard]] std::string blockText(dat::BlockCoord block);

} // namespace limen::engine
