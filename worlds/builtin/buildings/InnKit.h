#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/buildings/InnProps.h"
#include "worlds/shapes/RoomPlan.h"

// Shared by InnGround, InnUpper, InnBasement and InnRooms only.
namespace limen::worlds::inn {

// Openings between rooms, in the plane of either wall.
inline constexpr Rect kKitchenDoor{-5.5, 0.0, -4.5, 2.05};
inline constexpr Rect kParlourDoor{1.6, 0.0, 2.6, 2.05};
inline constexpr Rect kBackDoor{8.0, 0.0, 9.0, 2.05};
inline constexpr Rect kPassageDoor{1.8, 0.0, 2.72, 2.05};
inline constexpr Rect kStairsDoor{5.35, 0.0, 6.15, 2.05};
inline constexpr Rect kLandingDoor{9.85, kUpper, 10.65, kUpper + 2.05};
inline constexpr Rect kStoreDoor{5.4, 0.0, 6.3, 2.05};
inline constexpr Rect kWestRoomDoor{1.8, kUpper, 2.7, kUpper + 2.05};
inline constexpr Rect kNorthRoomDoor{7.0, kUpper, 7.9, kUpper + 2.05};
inline constexpr Rect kEastRoomDoor{1.8, kUpper, 2.7, kUpper + 2.05};
inline constexpr Rect kShaft{-2.2, 3.0, 0.8, 5.6};
inline constexpr Rect kDown{4.8, kDownHead, 6.0, 10.0};
inline constexpr Rect kBasementDoor{9.05, kBasement, 9.95, -0.6};
inline constexpr Rect kVaultArch{6.0, kBasement, 8.4, -0.75};

struct Kit {
    ModelWriter& writer;
    const Furniture& f;
    InnProps p;
};

/// A room with `openings`, then those of the outer walls, and with timber around all of them.
[[nodiscard]] CellPlan furnished(ModelWriter& writer, const RoomSpec& room, std::vector<Opening> openings,
                                 std::vector<Furnishing> statics);

[[nodiscard]] CellPlan innHall(Kit& kit);
[[nodiscard]] CellPlan kitchen(Kit& kit);
[[nodiscard]] CellPlan passage(Kit& kit);
[[nodiscard]] CellPlan parlour(Kit& kit);
[[nodiscard]] CellPlan store(Kit& kit);
[[nodiscard]] CellPlan stairs(Kit& kit);
[[nodiscard]] CellPlan landing(Kit& kit);
[[nodiscard]] CellPlan westRoom(Kit& kit);
[[nodiscard]] CellPlan northRoom(Kit& kit);
[[nodiscard]] CellPlan eastRoom(Kit& kit);
[[nodiscard]] CellPlan basementStairs(Kit& kit);
[[nodiscard]] CellPlan basement(Kit& kit);
[[nodiscard]] CellPlan vault(Kit& kit);

} // namespace limen::worlds::inn
