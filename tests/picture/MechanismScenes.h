#pragma once

#include "support/TestWorld.h"

#include "world/MovingEntries.h"

#include <optional>
#include <string>

namespace limen::test {

/// A named view of docs/proof.md: a small world, an eye in it, and the circumstances. Every cell is a zone of its own,
/// so that nothing is left to depth alone.
struct NamedView {
    TestWorld world;
    world::MovingEntries moving{};
    std::optional<double> doors{};         ///< how far they are open; none: nothing moves
    std::optional<TestWorld::Cell> root{}; ///< none: outside
    Vec3 eye{0.0};                         ///< local to the home block
    double yaw = 0.0, pitch = 0.0, fov = 75.0;
    std::uint32_t width = 96, height = 64;
};

[[nodiscard]] NamedView houseFromTheYard();    ///< a room seen from outside through its door
[[nodiscard]] NamedView hillBeforeTheTunnel(); ///< ground that runs through a tunnel's mouth
[[nodiscard]] NamedView hallBesideAWindow(); ///< a hall's rear opening passes behind a window of another room
[[nodiscard]] NamedView roundOpeningsInARow(); ///< far openings that begin exactly where nearer ones do
[[nodiscard]] NamedView noseInTheDoorway();    ///< half a millimetre before a doorway, gaze along it
[[nodiscard]] NamedView lintelOfAGate();      ///< 0.3 mm before a gate of 120 m, 0.02 mm under its upper edge
[[nodiscard]] NamedView eyeInTheDoorsPlane(); ///< exactly in it
[[nodiscard]] NamedView doorBehindAWindow();  ///< a far house's door passes behind the window of a near house
[[nodiscard]] NamedView someoneInADoorway();  ///< half in the room, half outside
[[nodiscard]] NamedView shutDoor();           ///< an opaque door between two rooms
[[nodiscard]] NamedView boardThroughAShutDoor(); ///< it pokes 0.15 mm through
[[nodiscard]] NamedView twoWindowsOnAMeadow();   ///< a tree for each, seen through one of them only
[[nodiscard]] NamedView boardsBehindAPanel(); ///< shelf boards at eye level, hidden by the panel before them
[[nodiscard]] NamedView
eavesBehindAnEdge(); ///< seen from below, hidden by the wall whose upper edge they share
/// Straight down along the edges of landings, one below the other, which lie on a diagonal of pixels' centres.
[[nodiscard]] NamedView landingsInAShaft();
[[nodiscard]] NamedView
stepFromAbove(); ///< straight down its riser, along which both edges lie on a diagonal of centres
[[nodiscard]] NamedView barsInAnOpening(); ///< a room's grating that stands 0.1 mm out of its opening

} // namespace limen::test
