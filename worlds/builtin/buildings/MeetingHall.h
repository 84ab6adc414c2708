#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The meeting hall's cells: a nave open to the roof, an apse behind an arch of more than eight edges.
enum class HallCell : std::uint32_t { Nave, Arch, Apse, Count };

/// The meeting hall south of the lane. In its coordinates the wide doorway is in the wall towards -x, the
/// floor at z = 0, y from 0 to kWidth.
[[nodiscard]] BuildingPlan planMeetingHall(ModelWriter& writer, const Furniture& furniture);

namespace hall {
inline constexpr double kHalfLength = 6.5, kWidth = 9.625, kWall = 0.375;
inline constexpr double kMiddle = kWidth / 2.0;
inline constexpr double kInnerEnd = kHalfLength - kWall; ///< |x| of the nave's end walls
inline constexpr double kApseWest = 6.875, kApseEast = 10.125;
} // namespace hall

} // namespace limen::worlds
