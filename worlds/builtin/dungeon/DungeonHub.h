#pragma once

#include "worlds/builtin/dungeon/DungeonPlan.h"

#include <array>

// The dungeon's parts, each built onto rooms that are there already.
namespace limen::worlds {

inline constexpr ShellMaterials kMasonry{Material::Flagstones, Material::StoneWall, Material::StoneWall};
inline constexpr ShellMaterials kBricks{Material::Flagstones, Material::Brick, Material::Brick};
inline constexpr ShellMaterials kBareRock{Material::Rock, Material::Rock, Material::Rock};

/// Corridors are arches 2.5 m wide and 2.75 m high.
inline constexpr double kArchSpring = 1.5, kArchHeight = 2.75;
[[nodiscard]] inline Outline corridorOutline(const Vec3& foot, const Vec3& across, double half = 1.25) {
    return archOutline({foot, across, half}, kArchSpring, kArchHeight);
}

/// A torch on a wall: `at` is a point of the wall, `wall` the way from the room to it, along an axis.
void hangTorch(CellComplex& complex, std::size_t cell, const DungeonProps& props, const Vec3& at,
               const Vec3& wall);

/// Upright box between two corners.
std::size_t addBoxCell(CellComplex& complex, const char* name, const Vec3& min, const Vec3& max,
                       const ShellMaterials& materials);

/// Rooms of the ring round the hub, from the southern one on, counter-clockwise.
enum class RingRoom : std::size_t { South, SouthEast, East, NorthEast, North, NorthWest, West, SouthWest };
struct Ring {
    std::size_t hub = 0, anteroom = 0;
    std::array<std::size_t, 8> rooms{};
    [[nodiscard]] std::size_t at(RingRoom room) const { return rooms[static_cast<std::size_t>(room)]; }
};
/// The middle of a room's floor.
[[nodiscard]] Vec3 ringRoomMiddle(RingRoom room);
/// From the middle of a ring room to its walls along the axes, metres.
inline constexpr double kRingRoomReach = 4.0;

/// The hub with nine openings in its eight walls, the rooms around it, spokes and the ring's corridors.
[[nodiscard]] Ring addHub(CellComplex& complex, ModelWriter& sink, const DungeonProps& props);

/// West of the ring: a shaft of stacked cells with galleries on three floors and ramps between them.
void addPit(CellComplex& complex, const DungeonProps& props, const Ring& ring, DungeonParts& parts);

/// North: a crypt, and a corridor from its eastern door round to its western one that overlaps it.
void addCrypt(CellComplex& complex, ModelWriter& sink, const DungeonProps& props, const Ring& ring,
              DungeonParts& parts);
/// South-east: a U-shaped room around a yard, with windows on it from both arms.
void addRecess(CellComplex& complex, const DungeonProps& props, const Ring& ring, DungeonParts& parts);
/// East: twelve cells in a row, and a shrine at their end.
void addLongCorridor(CellComplex& complex, ModelWriter& sink, const DungeonProps& props, const Ring& ring,
                     DungeonParts& parts);

} // namespace limen::worlds
