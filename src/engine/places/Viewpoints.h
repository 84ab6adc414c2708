#pragma once

#include "engine/places/Shapes.h"
#include "world/Places.h"

// Viewpoints that a visitor finds sensible: eyes of a standing body in free space.
namespace limen::engine {

/// A door of a building, seen from outside.
struct FrontDoor {
    std::size_t building = 0; ///< index in its block
    dat::RecordId cell = 0;   ///< the cell behind it
    std::size_t opening = 0;  ///< index of the cell's opening
    double step = 0.0;        ///< height of the sill above the ground in front, metres
};
/// The doors of a block's building that lead in from the ground, the lowest sill first, then the largest. Requires
/// a building of the block.
[[nodiscard]] std::vector<FrontDoor> frontDoors(Shapes& shapes, const BlockShape& block,
                                                std::size_t building);

/// An eye that sees a door from the ground outside: on the ground, with a free line to the door, no obstacle
/// within a metre and the sky above. No value if there is no such point. Requires a door that
/// frontDoors found.
[[nodiscard]] std::optional<world::Place> beforeDoor(Shapes& shapes, const BlockShape& block,
                                                     const FrontDoor& door);
/// The same for a building without doors; the eye looks at the middle of its exterior. Requires a building of the
/// block.
[[nodiscard]] std::optional<world::Place> beforeBuilding(Shapes& shapes, const BlockShape& block,
                                                         std::size_t building);
/// The viewpoint at the building of a block that is nearest to `near`, of up to eight buildings; one with a
/// door if there is one.
[[nodiscard]] std::optional<world::Place> beforeNearestBuilding(Shapes& shapes, const BlockShape& block,
                                                                const Vec3& near);

/// An eye above the ground with a view over the land: towards the lowest ground of eight directions. No value
/// without ground.
[[nodiscard]] std::optional<world::Place> aboveGround(Shapes& shapes, double x, double y);

/// Points of a cell's floor where a body can stand, as eyes: inside the walls, with headroom.
[[nodiscard]] std::vector<Vec3> standingEyes(const CellShape& cell);
/// A standing eye that looks through a portal of its cell, and a score: higher for longer and wider views.
struct CellViewpoint {
    world::Place place;
    double score = 0.0;
};
[[nodiscard]] std::optional<CellViewpoint> insideCell(const CellShape& cell);

/// Sets yaw and pitch towards a point.
void lookAt(world::Place& place, const Vec3& target);

} // namespace limen::engine
