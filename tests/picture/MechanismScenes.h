#pragma once

#include "support/TestWorld.h"

#include "world/MovingEntries.h"

#include <optional>
#include <string>

namespace limen::test {

/// A named view of docs/proof.md: a small world, an eye in it, and its settings. Every cell is a zone, so
/// that depth alone decides nothing.
struct NamedView {
    TestWorld world;
    world::MovingEntries moving{};
    std::optional<double> doors{};         ///< how far doors are open; empty: static
    std::optional<TestWorld::Cell> root{}; ///< none: outside
    Vec3 eye{0.0};                         ///< local to the home block
    double yaw = 0.0, pitch = 0.0, fov = 75.0;
    std::uint32_t width = 96, height = 64;
};

[[nodiscard]] NamedView houseFromTheYard();    ///< a room seen from outside through its door
[[nodiscard]] NamedView hillBeforeTheTunnel(); ///< ground that runs through a tunnel's mouth
[[nodiscard]] NamedView hallBesideAWindow();   ///< a hall's rear opening is behind a window of another room
[[nodiscard]] NamedView roundOpeningsInARow(); ///< far openings that begin exactly where nearer ones do
[[nodiscard]] NamedView noseInTheDoorway();    ///< 0.5 mm before a doorway, looking along it
[[nodiscard]] NamedView lintelOfAGate();      ///< 0.3 mm before a gate of 120 m, 0.02 mm below its upper edge
[[nodiscard]] NamedView eyeInTheDoorsPlane(); ///< exactly in its plane
[[nodiscard]] NamedView doorBehindAWindow();  ///< a far house's door is behind the window of a near house
[[nodiscard]] NamedView someoneInADoorway();  ///< half inside the room
[[nodiscard]] NamedView shutDoor();           ///< an opaque door between two rooms
[[nodiscard]] NamedView boardThroughAShutDoor(); ///< it extends 0.15 mm through
[[nodiscard]] NamedView twoWindowsOnAMeadow();   ///< one tree for each, seen through only one of them
[[nodiscard]] NamedView boardsBehindAPanel(); ///< shelf boards at eye level, hidden by the panel before them
[[nodiscard]] NamedView eavesBehindAnEdge(); ///< seen from below, hidden by the wall with the same upper edge
/// Straight down along the edges of landings, one below the other, on a diagonal of pixel centres.
[[nodiscard]] NamedView landingsInAShaft();
/// straight down its riser, with both edges on a diagonal of centres
[[nodiscard]] NamedView stepFromAbove();
[[nodiscard]] NamedView barsInAnOpening(); ///< a room's grating 0.1 mm outside its opening

} // namespace limen::test
