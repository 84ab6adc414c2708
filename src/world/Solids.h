#pragma once

#include "world/World.h"

#include "dat/Archive.h"

namespace limen::world {

/// One thing that bodies bump into: a cell's walls, a block's ground, a building's exterior, an object, what shuts a door, or a leaf.
struct Solid {
    InstanceKind kind = InstanceKind::Static;
    std::uint32_t firstTriangle = 0, triangleCount = 0; ///< Solids::corners, three each
    std::uint32_t firstMember = 0, memberCount = 0;     ///< Solids::members: the spaces it is met in
    std::uint32_t door = kNone; ///< World::doors, of a filling: it is there while this is shut
    std::uint32_t leaf =
        kNone; ///< World::leaves: corners are in the leaf's own frame, and it is there always
};

/// What stands around a place for bodies, by the records' physics shapes (docs/formats/geometry.md#setup): polygons of cells and models,
/// cylinders and spheres of setups as prisms and polyhedra around them. Either side is met. Plain data beside a World.
struct Solids {
    Vec3 origin{0.0};          ///< global; corners are relative to it, metres
    std::vector<Vec3> corners; ///< those of leaves apart
    std::vector<SpaceIndex> members;
    std::vector<Solid> solids;
    int radius = 0; ///< blocks each way around `centre` that it holds
    dat::BlockCoord centre;
};

/// Reads the solids of the blocks around `centre`, as far as `world` holds them; spaces and portals are the world's. The ground is cut
/// into squares of 3 m, so that no triangle reaches far. Records that cannot be read are left out: the loader has said so. Errors: the
/// Region cannot be read.
[[nodiscard]] Result<Solids> loadSolids(const dat::Archive& archive, const World& world,
                                        dat::BlockCoord centre, int radius);

} // namespace limen::world
