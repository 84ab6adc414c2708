#pragma once

#include "dat/records/Models.h"
#include "world/World.h"

#include <set>
#include <span>

namespace limen::world {

/// A polygon of a record, read as docs/formats/geometry.md#polygons-that-are-drawn, states. Positions are
/// in the record's space.
struct SourcePolygon {
    struct Corner {
        Vec3 position{0.0};
        Vec3 normal{0.0};
        Vec2f front{0.0f}, back{0.0f};
    };
    std::uint16_t id = 0;
    bool isPortal = false;
    std::int32_t frontSlot = -1; ///< surface slot of the positive side; -1: not drawn
    std::int32_t backSlot = -1;  ///< surface slot of the negative side; -1: not drawn
    std::vector<Corner> corners;

    [[nodiscard]] bool isDrawn() const { return !isPortal && (frontSlot >= 0 || backSlot >= 0); }
};

/// Reads a polygon list. Left out, with a finding under `record`: polygons with a vertex that is missing, not
/// finite or more than 100 km from the origin, and polygons beyond 65,535.
[[nodiscard]] std::vector<SourcePolygon>
readPolygons(const dat::VertexArray& vertices, const dat::PolygonList& polygons, std::size_t surfaceCount,
             const std::set<std::uint16_t>& portals, dat::RecordId record, std::vector<Finding>& findings);

/// The corners of all polygons of a list, drawn or not, for physics shapes. Polygons that readPolygons leaves
/// out for their vertices are left out here, too.
[[nodiscard]] std::vector<std::vector<Vec3>> readOutlines(const dat::VertexArray& vertices,
                                                          const dat::PolygonList& polygons);

/// A portal polygon of a mesh and the building portal it belongs to.
struct PortalPolygonRef {
    std::uint16_t polygonId = 0;
    std::uint16_t portalIndex = 0;
};

inline constexpr std::size_t kAnyPortalCount = 0x10000; ///< for portalRefs: checks polygon ids only
/// The references in the PORT nodes of a drawing tree. The two words are (polygonId, portalIndex). If some
/// pair does not fit the mesh or `portalCount` and all swapped pairs do, all are swapped
/// (docs/formats/geometry.md#bsp-trees). Pairs that do not fit are then dropped.
[[nodiscard]] std::vector<PortalPolygonRef> portalRefs(const dat::GfxObj& model, std::size_t portalCount);

} // namespace limen::world
