#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The inn's cells, in the order of its plan. The rooms on the ground floor form a loop: hall, kitchen,
/// passage, parlour, hall. A tall stairwell leads to the upper floor, from which a shaft looks down into the
/// hall. The way to the basement is through the floor of the store room.
enum class InnCell : std::uint32_t {
    Hall,
    KitchenDoor,
    Kitchen,
    BackDoor, ///< between kitchen and passage
    Passage,
    PassageDoor,
    Parlour,
    ParlourDoor,
    StairsDoor,
    Stairs,
    LandingDoor,
    Landing,
    Shaft,
    WestRoomDoor,
    WestRoom,
    NorthRoomDoor,
    NorthRoom,
    EastRoomDoor,
    EastRoom,
    StoreDoor,
    Store,
    BasementStairs,
    BasementDoor,
    Basement,
    VaultArch,
    Vault,
    Count
};
/// The inn north of the lane. In its coordinates the front door is in the wall at y = 0, the ground floor at
/// z = 0.
[[nodiscard]] BuildingPlan planInn(ModelWriter& writer, const Furniture& furniture);

/// Positions inside, for walks (building coordinates).
namespace inn {
inline constexpr double kHeight = 2.8;                        ///< height of the rooms on the ground floor
inline constexpr double kUpper = 3.05, kTop = 5.5;            ///< floor and ceiling of the upper floor
inline constexpr double kBalcony = 3.03;                      ///< the boards of the balcony
inline constexpr double kBasement = -2.6;                     ///< floor of the basement
inline constexpr double kUpX = 3.8;                           ///< middle of the stairs up
inline constexpr double kStairsFoot = 6.2, kStairsHead = 9.8; ///< y of the lowest and the highest riser
inline constexpr double kDownX = 5.4;                         ///< middle of the stairs down
inline constexpr double kDownHead = 6.4, kDownRun = 2.64;
inline constexpr double kHearthY = 3.35;
/// The mouth of the chimney and the middle of the fire.
[[nodiscard]] Vec3 chimneyMouth();
[[nodiscard]] Vec3 hearthFire();
} // namespace inn

} // namespace limen::worlds
