#pragma once

#include "world/mesh/Models.h"
#include "world/terrain/Terrain.h"

namespace limen::world {

/// The outside, in the place of a cell's index. kNone means no space.
inline constexpr std::uint32_t kOutdoorSpace = kNone - 1;

/// A portal of a cell or of a building. Its indices are relative to the block.
struct PortalContent {
    std::uint32_t space = kNone;       ///< cell, or kOutdoorSpace
    std::uint32_t destination = kNone; ///< cell, kOutdoorSpace or kNone
    std::uint32_t reciprocal = kNone;  ///< portal
    std::vector<Vec3>
        points; ///< block-local, counter-clockwise seen from `space`; empty: a defective polygon
    std::vector<Vec3> corners;   ///< the convex hull of the record's own corners; a subset of `points`
    Plane plane{Vec3(0.0), 0.0}; ///< block-local; `space` is on the positive side
    bool exact = true;
    bool walled = false; ///< its polygon is drawn towards `space`, and is opaque
    std::uint16_t recordIndex = 0, polygonId = 0;
    std::uint16_t part = 0, partCount = 1;                   ///< as Portal::part
    std::uint32_t whole = kNone;                             ///< index into BlockContent::wholes
    std::uint16_t flags = 0, otherCell = 0, otherPortal = 0; ///< as in the record
};

/// The data of a cell that groupIntoZones needs. Block-local.
struct CellShape {
    bool closed = false; ///< every edge of shell and portals runs as often one way as the other
    Aabb bounds;
    std::vector<Vec3> points; ///< vertices of shell and portals
    std::vector<Vec3>
        normals; ///< unit normals of its faces, each direction once, opposite ones counting as one
    std::vector<Vec3> edges; ///< unit directions of its edges, each once, opposite ones counting as one
};

struct CellContent {
    dat::RecordId id = 0;
    bool seenOutside = false, ofBuilding = false;
    Vec3 origin{0.0}; ///< of its own frame, block-local
    MeshData shell;   ///< block-local
    std::vector<dat::RecordId> surfaces;
    std::vector<bool> clamp;                        ///< by slot: false if its picture repeats
    std::uint32_t firstPortal = 0, portalCount = 0; ///< run of BlockContent::portals
    std::vector<CellBspNode> bsp;                   ///< block-local planes
    CellShape shape;
};

/// A part of a building's exterior, block-local.
struct ExteriorContent {
    dat::RecordId gfxObj = 0;
    std::uint64_t object = 0;
    MeshData mesh;
    std::vector<dat::RecordId> surfaces;
    std::vector<bool> clamp; ///< by slot: false if its picture repeats
};

/// A model placed in the block.
struct PlacedModel {
    InstanceKind kind = InstanceKind::Static;
    dat::RecordId model = 0;
    std::uint64_t object = 0;
    Vec3 origin{0.0}; ///< block-local
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
    std::uint32_t cell = kOutdoorSpace;
    dat::RecordId motionTable = 0; ///< 0: that of the Setup
    double opacity = 1.0;          ///< below 1 all of its surfaces are blended
    const Dress* dress = nullptr;  ///< null: none; outlives the call that adds the object
    dat::RecordId scriptTable = 0; ///< 0: that of the Setup
    PlayEntry play{};
};

/// The content of one landblock in its own frame and with its own indices. It does not depend on other
/// resident blocks, so blocks can be built on several threads and in any order.
struct BlockContent {
    dat::BlockCoord coord;
    bool isFar = false; ///< its ground alone
    std::optional<Ground> ground;
    std::vector<std::uint8_t> heightIndices;
    MeshData terrain;
    std::vector<CellContent> cells;     ///< ascending ids
    std::vector<PortalContent> portals; ///< by cell, then those of buildings
    std::vector<PortalContent> wholes;  ///< openings that are cut into parts
    std::uint32_t firstOutdoorPortal = 0;
    std::vector<std::vector<std::uint32_t>> zones; ///< cells
    std::vector<ExteriorContent> exteriors;
    std::vector<PlacedModel> objects;
    std::vector<Finding> findings;       ///< about its own records
    std::vector<Finding> recordFindings; ///< about records of the portal file that it uses
};

} // namespace limen::world
