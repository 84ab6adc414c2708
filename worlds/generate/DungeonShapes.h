#pragma once

#include "worlds/generate/DungeonLayout.h"
#include "worlds/records/ShapeLibrary.h"

#include <map>

namespace limen::worlds {

/// A room's shell around the middle of its floor; portals in the order of Way. The surfaces are Flagstones
/// (floor), StoneWall (walls), Brick (ceiling).
[[nodiscard]] std::vector<Face> roomShell(const LatticeRoom& room);

/// A point at eye height, relative to the middle of the floor, from which every corner of the room is
/// visible. It is not above the edge of a hatch.
[[nodiscard]] Vec3 eyePoint(Form form);

/// A passage's shell: along +x from the origin, `rise` metres higher at its end. The openings at x = 0 come
/// first; a dead end has no others.
[[nodiscard]] std::vector<Face> passageShell(Door door, double length, double rise, bool deadEnd);
/// A shaft from z = 0 up to `length`, with horizontal openings: the lower one first.
[[nodiscard]] std::vector<Face> shaftShell(Door door, double length);

/// The frame of a passage: its origin is at the side of the room where it starts.
[[nodiscard]] Placement passagePlacement(const Passage& passage, const LatticeRoom& from);

/// Stores the shapes of rooms and passages, equal ones once.
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
