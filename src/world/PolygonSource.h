#pragma once

#include "dat/records/Models.h"
#include "world/World.h"

#include <set>
#include <span>

namespace limen::world {

/// A polygon of a record as docs/formats/geometry.md#polygons-that-are-drawn reads it. Positions are in the record's space.
struct SourcePolygon {
    struct Corner {
        Vec3 position{0.0};
        Vec3 normal{0.0};
        Vec2f front{0.0f}, back{0.0f};
    };
    std::uint16_t id = 0;
    bool isPortal = false;
    std::int32_t frontSlot = -1; ///< surface slot of the positive side, -1: not drawn
    std::int32_t backSlot = -1;  ///< of the negative side
    std::vector<Corner> corners;

    [[nodiscard]] bool isDrawn() const { return !isPortal && (frontSlot >= 0 || backSlot >= 0); }
};

/// Reads a polygon list. Polygons with a missing vertex, or one that is not finite or absurdly far away, are
/// left out and said in `findings` under `record`; so is what cannot be numbered.
[[nodiscard]] std::vector<SourcePolygon>
readPolygons(const dat::VertexArray& vertices, const dat::PolygonList& polygons, std::size_t surfaceCount,
             const std::set<std::uint16_t>& portals, dat::RecordId record, std::vector<Finding>& findings);

/// The corners of all polygons of a list, whether they are drawn or not: of physics shapes. Those that readPolygons would leave out for
/// their vertices are left out, too.
[[nodiscard]] std::vector<std::vector<Vec3>> readOutlines(const dat::VertexArray& vertices,
                                                          const dat::PolygonList& polygons);

/// A portal polygon of a mesh and the building portal it belongs to.
struct PortalPolygonRef {
    std::uint16_t polygonId = 0;
    std::uint16_t portalIndex = 0;
};

/// What the PORT nodes of a drawing tree name. Words are (polygonId, portalIndex); if that does not fit the
/// mesh or `portalCount` anywhere while the swapped reading does, all are swapped (docs/formats/geometry.md#bsp-trees). A
/// count of kAnyPortalCount checks polygons only. References that fit neither way are dropped.
inline constexpr std::size_t kAnyPortalCount = 0x10000;
[[nodiscard]] std::vector<PortalPolygonRef> portalRefs(const dat::GfxObj& model, std::size_t portalCount);

} // namespace limen::world
