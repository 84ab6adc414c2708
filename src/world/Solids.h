#pragma once

#include "dat/Archive.h"
#include "world/World.h"

namespace limen::world {

/// One obstacle of bodies: the walls of a cell, the ground of a block, the exterior of a building, an object,
/// the filling of a shut door, or a door leaf.
struct Solid {
    InstanceKind kind = InstanceKind::Static;
    std::uint32_t firstTriangle = 0, triangleCount = 0; ///< of Solids::corners, three corners each
    std::uint32_t firstMember = 0, memberCount = 0; ///< run of Solids::members: the spaces in which it blocks
    std::uint32_t door = kNone; ///< World::doors: of a filling, which blocks while the door is shut
    std::uint32_t leaf =
        kNone; ///< World::leaves: of a leaf, which always blocks; its corners are in the leaf's frame
};

/// The obstacles around a place, from the records' physics shapes (docs/formats/geometry.md#setup):
/// polygons of cells and models; cylinders and spheres of Setups as prisms and polyhedra. Triangles block
/// from both sides. Plain data beside a World.
struct Solids {
    Vec3 origin{0.0};          ///< global, metres
    std::vector<Vec3> corners; ///< relative to `origin`, except those of leaves
    std::vector<SpaceIndex> members;
    std::vector<Solid> solids;
    int radius = 0; ///< blocks each way around `centre`
    dat::BlockCoord centre;
};

/// Reads the solids of those blocks around `centre` that `world` contains. The ground is cut into squares of
/// 3 m, which keeps triangles small. Records that cannot be read are left out; the loader has reported them.
/// Errors: the Region cannot be read.
[[nodiscard]] Result<Solids> loadSolids(const dat::Archive& archive, const World& world,
                                        dat::BlockCoord centre, int radius);

} // namespace limen::world
