#pragma once

#include "worlds/records/ModelWriter.h"
#include "worlds/shapes/RoomPlan.h"

namespace limen::worlds {

/// An opening and the plane of the wall it is in.
struct WallOpening {
    Opening opening;
    double at = 0.0;
};

/// Timber around openings as seen from inside a room whose floor lies at `floor`; windows (openings that begin above
/// it) get a sill. Stands at the building's origin.
[[nodiscard]] dat::RecordId addTrim(ModelWriter& sink, const std::vector<WallOpening>& openings,
                                    double floor = 0.0);

/// The piece of wall or floor that an opening goes through: a box that is open at both ends along an axis.
enum class Axis { X, Y, Z };
[[nodiscard]] CellPlan doorway(const char* name, const Vec3& min, const Vec3& max, Axis axis, Material walls,
                               Material floor);

} // namespace limen::worlds
