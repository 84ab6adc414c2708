#pragma once

#include "world/block/BlockContent.h"
#include "world/mesh/BakedGeometry.h"

namespace limen::world {

/// A building whose polygons are read, but not baked.
struct BuildingDraft {
    struct Part {
        dat::RecordId gfxObj = 0;
        std::vector<dat::RecordId> surfaces;
        std::vector<std::uint32_t> polygons; ///< BakedGeometry handles
    };
    std::uint64_t object = 0;
    std::vector<Part> parts;
    struct PortalPolygon {
        std::vector<Vec3> corners;                    ///< block-local; empty: it is not in the model
        bool opaqueFront = false, opaqueBack = false; ///< the side is drawn, and is opaque
    };
    std::vector<PortalPolygon> portalPolygons; ///< by building portal
};

/// Reads a building's model and adds its drawn polygons to `geometry`. The portal polygons of its drawing
/// tree go to the draft.
[[nodiscard]] BuildingDraft draftBuilding(const dat::Building& building, std::uint64_t object,
                                          Records& records, Models& models, BakedGeometry& geometry,
                                          std::vector<Finding>& findings);

/// Appends the building's meshes to the block's exteriors. Requires: `geometry` is baked.
void finishBuilding(const BuildingDraft& draft, const BakedGeometry& geometry, Records& records,
                    BlockContent& block);

} // namespace limen::world
