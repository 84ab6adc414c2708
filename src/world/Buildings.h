#pragma once

#include "world/BakedGeometry.h"
#include "world/BlockContent.h"

namespace limen::world {

/// A building between reading its polygons and baking them.
struct BuildingDraft {
    struct Part {
        dat::RecordId gfxObj = 0;
        std::vector<dat::RecordId> surfaces;
        std::vector<std::uint32_t> polygons; ///< BakedGeometry handles
    };
    std::uint64_t object = 0;
    std::vector<Part> parts;
    std::vector<std::vector<Vec3>>
        portalPolygons; ///< block-local, by building portal; empty: none in the model
};

/// Reads a building's model and adds its drawn polygons to `geometry`. Portal polygons of its drawing tree
/// are kept aside.
[[nodiscard]] BuildingDraft draftBuilding(const dat::Building& building, std::uint64_t object,
                                          Records& records, Models& models, BakedGeometry& geometry,
                                          std::vector<Finding>& findings);

/// After baking: the building's meshes are appended to the block's exteriors.
void finishBuilding(const BuildingDraft& draft, const BakedGeometry& geometry, Records& records,
                    BlockContent& block);

} // namespace limen::world
