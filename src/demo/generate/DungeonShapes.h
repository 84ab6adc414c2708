#pragma once

#include "demo/generate/DungeonLayout.h"
#include "demo/generate/ShapeLibrary.h"

#include <map>

namespace limen::demo {

/// How many openings a door is made of.
[[nodiscard]] std::uint16_t openingsOf(Door door);

/// The middle of an opening (x along the wall, seen as in a passage to the east; y up) and its extents, and whether it
/// is a rectangle.
struct DoorExtent {
    double from = 0.0, to = 0.0, height = 0.0;
    bool rectangular = true;
};
[[nodiscard]] DoorExtent extentOf(Door door, std::uint16_t opening);

/// A room's shell around the middle of its floor; portals in the order of Way. The surfaces are Flagstones (floor),
/// StoneWall (walls), Brick (ceiling).
[[nodiscard]] std::vector<Face> roomShell(const LatticeRoom& room);

/// A point at eye's height that sees every corner of the room, from the middle of its floor; clear of hatches' edges.
[[nodiscard]] Vec3 eyePoint(Form form);

/// A passage's shell: along +x from the origin, `rise` higher at its end, openings at x = 0 first; a dead end has
/// no others.
[[nodiscard]] std::vector<Face> passageShell(Door door, double length, double rise, bool deadEnd);
/// The same upwards, between horizontal openings: below first.
[[nodiscard]] std::vector<Face> shaftShell(Door door, double length);

/// The frame of a passage: from the side of the room it starts at.
[[nodiscard]] Placement passagePlacement(const Passage& passage, const LatticeRoom& from);

/// Shapes of rooms and passages, each stored once.
class DungeonShapes {
public:
    explicit DungeonShapes(ShapeLibrary& library) : library_(library) {}
    const StoredShape& of(const LatticeRoom& room);
    const StoredShape& of(const Passage& passage, double rise);

private:
    ShapeLibrary& library_;
    std::map<std::array<long long, 10>, StoredShape> shapes_;
};

} // namespace limen::demo
