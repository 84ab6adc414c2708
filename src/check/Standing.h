#pragma once

#include "check/RandomGenerator.h"
#include "check/Views.h"

#include <optional>

// Where an eye may be.
namespace limen::check {

/// The cells of a block, ascending.
[[nodiscard]] std::vector<world::SpaceIndex> cellsOf(const world::World& world, dat::BlockCoord block);

/// The openings of a block's cells, each once, by the portal that leads out of the cell (of two cells, the one with the
/// smaller index). Those that lead nowhere are left out.
[[nodiscard]] std::vector<world::PortalIndex> openingsOf(const world::World& world, dat::BlockCoord block);

/// The mean of a portal's corners.
[[nodiscard]] Vec3 middleOf(const world::World& world, const world::Portal& portal);

/// The space that a straight way from `from` in `space` to `to` leads into; nothing if a surface stands in the way.
/// Touching one at the very end is fine.
[[nodiscard]] std::optional<world::SpaceIndex> walk(const Surroundings& around, world::SpaceIndex space,
                                                    const Vec3& from, const Vec3& to);

/// False if the eye is within something solid or behind a wall of its space. Surfaces are one-sided, so what is seen
/// from there is no proof; but whatever an eye in the open sees can be walked back from, and there a wall is met.
[[nodiscard]] bool standsFree(const Surroundings& around, world::SpaceIndex space, const Vec3& eye,
                              RandomGenerator& random);

/// A legal place in a cell; nothing if none is found.
[[nodiscard]] std::optional<Vec3> placeInCell(const Surroundings& around, world::SpaceIndex cell,
                                              RandomGenerator& random);

/// Yaw and pitch (degrees) of a direction that is not zero.
struct Gaze {
    double yaw = 0.0, pitch = 0.0;
};
[[nodiscard]] Gaze gazeAlong(const Vec3& direction);

/// The id of a space's cell, 0 for outside.
[[nodiscard]] dat::RecordId cellIdOf(const world::World& world, world::SpaceIndex space);

} // namespace limen::check
