#pragma once

#include "dat/records/Models.h"
#include "world/World.h"

#include <set>
#include <span>
#include <vector>

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
    bool frontRepeats = false, backRepeats = false; ///< the side's picture repeats; false: it is clamped
    std::int32_t frontSlot = -1;                    ///< surface slot of the positive side; -1: not drawn
    std::int32_t backSlot = -1;                     ///< surface slot of the negative side; -1: not drawn
    bool backIsLitAsFront = false;                  ///< the negative side has the positive side's normals
    std::vector<Corner> corners;

    [[nodiscard]] bool isDrawn() const { return frontSlot >= 0 || backSlot >= 0; }
};

class Records;

/// The owner of a mesh. Surfaces without a picture are not drawn in structures: rooms and building exteriors.
enum class MeshOwner : std::uint8_t { Thing, Structure };
/// By slot: whether a polygon with that surface is drawn. A missing Surface is drawn, in grey.
[[nodiscard]] std::vector<bool> drawnSlots(std::span<const dat::RecordId> surfaces, MeshOwner owner,
                                           Records& records);

/// Reads a polygon list. `drawn`: by surface slot. Polygons that are neither drawn nor portals are left out. Left out, with a finding under `record`: polygons with a vertex that is missing, not
/// finite or more than 100 km from the origin, and polygons beyond 65,535.
[[nodiscard]] std::vector<SourcePolygon> readPolygons(const dat::VertexArray& vertices,
                                                      const dat::PolygonList& polygons,
                                                      const std::vector<bool>& drawn,
                                                      const std::set<std::uint16_t>& portals,
                                                      dat::RecordId record, std::vector<Finding>& findings);

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
/// The references in the PORT nodes of a drawing tree. Those that do not fit the mesh or `portalCount` are
/// dropped.
[[nodiscard]] std::vector<PortalPolygonRef> portalRefs(const dat::GfxObj& model, std::size_t portalCount);

} // namespace limen::world
