#pragma once

#include "worlds/records/ModelWriter.h"
#include "worlds/shapes/RoomPlan.h"

namespace limen::worlds {

/// An opening and the plane of its wall.
struct WallOpening {
    Opening opening;
    double at = 0.0;
};

/// Timber around openings, seen from inside a room with its floor at `floor`. Windows (openings that begin
/// above it) get a sill. The model's origin is the building's.
[[nodiscard]] dat::RecordId addTrim(ModelWriter& writer, const std::vector<WallOpening>& openings,
                                    double floor = 0.0);

/// The direction of a cell inside a wall or floor: a box that is open at both ends.
enum class Axis { X, Y, Z };
[[nodiscard]] CellPlan doorway(const char* name, const Vec3& min, const Vec3& max, Axis axis, Material walls,
                               Material floor);

} // namespace limen::worlds
