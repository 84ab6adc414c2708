#pragma once

#include "worlds/Mesh.h"
#include "worlds/WorldRecords.h"

namespace limen::worlds {

/// A stored cell shape: what an EnvCell needs to use it.
struct StoredShape {
    std::uint16_t environment = 0, structure = 0;
    std::vector<std::uint16_t> portalPolygons; ///< by portal
    std::vector<std::uint16_t> surfaces;       ///< low words, in the order of the shape's slots
};

/// Adds cell shapes to a world's Environments, so many to each.
class ShapeLibrary {
public:
    explicit ShapeLibrary(WorldRecords& records) : records_(records) {}

    /// `faces` look inwards and close, T-junctions apart (they are closed here); portal faces are the cell's
    /// portals, in order. Those in `outwardPortals` are stored wound the other way round. Of a cell that is not
    /// convex, the tree's chain of positive children is a convex part around `middle`.
    StoredShape add(std::vector<Face> faces, const Vec3& middle,
                    const std::vector<bool>& outwardPortals = {});

private:
    WorldRecords& records_;
};

/// A cell tree for any closed shell whose faces look inwards: in front of a node's plane lies the positive
/// child, behind it the negative one; a missing negative child is outside. One chain of positive children if
/// the shell is convex; else a convex part that holds `middle`, a point that some convex part of the shell's own planes
/// holds.
[[nodiscard]] dat::BspTree buildSolidCellBsp(const std::vector<Face>& faces, const Vec3& middle);

} // namespace limen::worlds
