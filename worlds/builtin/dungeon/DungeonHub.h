#pragma once

#include "worlds/builtin/dungeon/DungeonPlan.h"

#include <array>

// Each function adds a part of the dungeon to existing rooms.
namespace limen::worlds {

inline constexpr ShellMaterials kMasonry{Material::Flagstones, Material::StoneWall, Material::StoneWall};
inline constexpr ShellMaterials kBricks{Material::Flagstones, Material::Brick, Material::Brick};
inline constexpr ShellMaterials kBareRock{Material::Rock, Material::Rock, Material::Rock};

/// Corridors are arches 2.5 m wide and 2.75 m high.
inline constexpr double kArchSpring = 1.5, kArchHeight = 2.75;
[[nodiscard]] inline Outline corridorOutline(const Vec3& foot, const Vec3& across, double half = 1.25) {
    return archOutline({foot, across, half}, kArchSpring, kArchHeight);
}

/// Adds a torch to a wall: `at` is a point of the wall, `wall` the direction from the room to it, along an
/// axis.
void hangTorch(CellComplex& complex, std::size_t cell, const DungeonProps& props, const Vec3& at,
               const Vec3& wall);

/// Adds an upright box between two corners.
std::size_t addBoxCell(CellComplex& complex, const char* name, const Vec3& min, const Vec3& max,
                       const ShellMaterials& materials);

/// Rooms of the ring round the hub, counter-clockwise, beginning with the southern one.
enum class RingRoom : std::size_t { South, SouthEast, East, NorthEast, North, NorthWest, West, SouthWest };
struct Ring {
    std::size_t hub = 0, anteroom = 0;
    std::array<std::size_t, 8> rooms{};
    [[nodiscard]] std::size_t at(RingRoom room) const { return rooms[static_cast<std::size_t>(room)]; }
};
/// The middle of a room's floor.
[[nodiscard]] Vec3 ringRoomMiddle(RingRoom room);
/// Metres from the middle of a ring room to its walls along the axes.
inline constexpr double kRingRoomReach = 4.0;

/// Adds the hub with nine openings in its eight walls, the rooms around it, the spokes and the ring's
/// corridors.
[[nodiscard]] Ring addHub(CellComplex& complex, ModelWriter& writer, const DungeonProps& props);

/// Adds, west of the ring, a shaft of stacked cells with galleries on three floors and ramps between them.
void addPit(CellComplex& complex, const DungeonProps& props, const Ring& ring, DungeonParts& parts);

/// Adds, in the north, a crypt and a corridor from its eastern door to its western one. The corridor overlaps
/// the crypt.
void addCrypt(CellComplex& complex, ModelWriter& writer, const DungeonProps& props, const Ring& ring,
              DungeonParts& parts);
/// Adds, in the south-east, a U-shaped room around a yard, with windows to the yard from both arms.
void addRecess(CellComplex& complex, const DungeonProps& props, const Ring& ring, DungeonParts& parts);
/// Adds, in the east, twelve cells in a row and a shrine at their end.
void addLongCorridor(CellComplex& complex, ModelWriter& writer, const DungeonProps& props, const Ring& ring,
                     DungeonParts& parts);

} // namespace limen::worlds
