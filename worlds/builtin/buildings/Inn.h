#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The inn's cells, in the order of its plan. Its rooms on the ground floor make a loop: hall, kitchen, passage,
/// parlour, hall. A tall well holds the stairs to the upper floor, which looks down into the hall through a shaft; the
/// basement is reached through the floor of the store room.
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
/// North of the lane. Its own coordinates: front door in the wall at y = 0, ground floor at z = 0.
[[nodiscard]] BuildingPlan planInn(ModelWriter& sink, const Furniture& furniture);

/// Where things are inside, for whoever walks there (building coordinates).
namespace inn {
inline constexpr double kHeight = 2.8;                        ///< of the rooms on the ground floor
inline constexpr double kUpper = 3.05, kTop = 5.5;            ///< floor and ceiling above
inline constexpr double kBalcony = 3.03;                      ///< the boards of the balcony
inline constexpr double kBasement = -2.6;                     ///< the floor below
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
