#pragma once

#include "engine/places/Viewpoints.h"

#include <set>

// Ways of a standing body through cells.
namespace limen::engine {

/// A point of a way: an eye and the cell it is in (0: outside).
struct WayPoint {
    Vec3 eye{0.0};
    dat::RecordId cell = 0;
};

/// True if a body can go straight from eye to eye in a cell: no wall or object in the way, and a floor without
/// a high step beneath.
[[nodiscard]] bool isWalkable(const CellShape& cell, const Vec3& from, const Vec3& to);

/// The eyes between `from` and `to` in one cell, without `from` and with `to`: the shortest way through
/// `stops`. Empty if there is none.
[[nodiscard]] std::vector<Vec3> wayInside(const CellShape& cell, const Vec3& from, const Vec3& to,
                                          const std::vector<Vec3>& stops);

/// The eye straight behind a door of a cell, 0.6 to 1.5 metres from it: ways turn there, and not beside the
/// open leaf of the door. Nullopt if no such point is free. Requires an upright door (Opening::isDoor).
[[nodiscard]] std::optional<Vec3> squareBehind(const CellShape& cell, const Opening& door);

/// Appends a round through a cell and the cells behind its doors, back to the entry. `entry`: an eye just
/// inside. `rooms` bounds the number of cells and is reduced.
void roundThroughRooms(Shapes& shapes, dat::RecordId cell, const Vec3& entry, std::size_t& rooms,
                       std::set<dat::RecordId>& visited, std::vector<WayPoint>& out);

} // namespace limen::engine
