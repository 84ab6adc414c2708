#pragma once

#include "check/views/RandomGenerator.h"
#include "check/views/Views.h"

#include <optional>

// Legal positions of an eye.
namespace limen::check {

/// The cells of a block, ascending.
[[nodiscard]] std::vector<world::SpaceIndex> cellsOf(const world::World& world, dat::BlockCoord block);

/// The openings of a block's cells, each once, by the portal that leads out of the cell (of two cells, out of
/// the one with the smaller index). Portals that lead nowhere are left out.
[[nodiscard]] std::vector<world::PortalIndex> openingsOf(const world::World& world, dat::BlockCoord block);

/// The mean of a portal's corners.
[[nodiscard]] Vec3 middleOf(const world::World& world, const world::Portal& portal);

/// The space at the end of a straight way from `from` in `space` to `to`; none if a surface is in the way.
/// The end itself may touch a surface.
[[nodiscard]] std::optional<world::SpaceIndex> walk(const Surroundings& around, world::SpaceIndex space,
                                                    const Vec3& from, const Vec3& to);

/// False if the eye is inside a solid or behind a wall of its space. Surfaces are one-sided, so the view from
/// there shows nothing unusual. But a ray back from any point seen by a free eye reaches the eye, and a ray
/// back to a hidden one meets a wall.
[[nodiscard]] bool isFreeViewpoint(const Surroundings& around, world::SpaceIndex space, const Vec3& eye,
                                   RandomGenerator& random);

/// A random legal viewpoint in a cell; none if the search fails.
[[nodiscard]] std::optional<Vec3> viewpointInCell(const Surroundings& around, world::SpaceIndex cell,
                                                  RandomGenerator& random);

/// The angles of a direction; degrees.
struct Gaze {
    double yaw = 0.0, pitch = 0.0;
};
/// Requires a direction that is not zero.
[[nodiscard]] Gaze gazeAlong(const Vec3& direction);

/// The id of a space's cell, 0 for outside.
[[nodiscard]] dat::RecordId cellIdOf(const world::World& world, world::SpaceIndex space);

} // namespace limen::check
