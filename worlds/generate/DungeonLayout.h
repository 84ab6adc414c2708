#pragma once

#include "geometry/Vec.h"
#include "worlds/shapes/Random.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace limen::worlds {

/// The six directions out of a room, in the order of its openings. A direction and its opposite differ in bit
/// 0.
enum class Way : std::uint8_t { West, East, South, North, Down, Up };
inline constexpr std::size_t kWays = 6;
[[nodiscard]] constexpr std::size_t opposite(std::size_t way) {
    return way ^ 1u;
}

/// The openings in a direction. Down and up use the first two: a square and an octagon.
enum class Door : std::uint8_t { Narrow, Wide, Twin, Arch, None };

/// A box, a box without one corner, or a box without the middle of one side.
enum class Form : std::uint8_t {
    Box,
    NoSouthWest,
    NoSouthEast,
    NoNorthWest,
    NoNorthEast,
    NoWest,
    NoEast,
    NoSouth,
    NoNorth
};

/// Half the extents along x and y, and the height; metres.
struct RoomSize {
    double halfX = 0.0, halfY = 0.0, height = 0.0;
};
inline constexpr std::array<RoomSize, 6> kRoomSizes{
    {{5.0, 4.0, 3.5}, {3.0, 3.0, 3.0}, {6.5, 6.5, 4.0}, {8.0, 8.0, 5.0}, {8.0, 4.0, 3.5}, {4.0, 6.0, 6.0}}};

inline constexpr std::uint32_t kNothing = 0xFFFFFFFFu;

/// A room at a node of the lattice.
struct LatticeRoom {
    std::array<int, 3> node{};
    std::uint8_t size = 0; ///< of kRoomSizes
    Form form = Form::Box;
    std::array<Door, kWays> doors{Door::None, Door::None, Door::None, Door::None, Door::None, Door::None};
    std::array<std::uint32_t, kWays> passages{kNothing, kNothing, kNothing, kNothing, kNothing, kNothing};
    Vec3 floor{0.0}; ///< middle of the floor
    std::uint32_t cell = 0;
};

/// The connection of a room's east, north or upper side to another room.
struct Passage {
    std::uint32_t from = 0, to = kNothing; ///< rooms; kNothing for a dead end
    Way way = Way::East;                   ///< out of `from`
    Door door = Door::Narrow;
    std::uint32_t cell = kNothing; ///< kNothing if the rooms share a wall
    double length = 0.0;
};

struct DungeonLayout {
    std::vector<LatticeRoom> rooms;
    std::vector<Passage> passages;
    std::uint32_t cells = 0;
    std::uint32_t crossings = 0; ///< passages that run through another room
};

/// Lays out exactly `cells` >= 1 connected cells; the share `overlapShare` of them are passages through
/// rooms.
[[nodiscard]] DungeonLayout layOutDungeon(std::uint32_t cells, double overlapShare, Random random);

} // namespace limen::worlds
