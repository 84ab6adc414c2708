#pragma once

#include "worlds/generate/DungeonLayout.h"
#include "worlds/records/ShapeLibrary.h"

#include <map>

namespace limen::worlds {

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
    const StoredShape& store(const std::array<long long, 10>& key, std::vector<Face> faces,
                             const Vec3& middle);

    ShapeLibrary& library_;
    std::map<std::array<long long, 10>, StoredShape> shapes_;
};

} // namespace limen::worlds
