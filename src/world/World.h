#pragma once

#include "dat/Ids.h"
#include "geometry/Bounds.h"
#include "geometry/Plane.h"
#include "geometry/TwoFloats.h"
#include "world/Facing.h"
#include "world/Image.h"
#include "world/Index.h"
#include "world/LevelRange.h"
#include "world/Moving.h"
#include "world/Particles.h"
#include "world/Readings.h"
#include "world/Sky.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

// The resident world as plain arrays that index each other. Built by world/Loader.h, immutable afterwards,
// shared by motion, visibility (as a graph), frame and reference.
//
// Spaces: "global" is metres from the south-west corner of landblock 0x0000, x east, y north, z up, in
// double. "Block-local" is metres from the south-west corner of a landblock. Static geometry is block-local
// and in float, because a float is exact to 0.02 mm within 192 m. Shells, exteriors and portals must meet. So
// their corners are stored in two floats, whose sum is as exact as the data; with one float, touching cells
// would overlap by its rounding error. Corners that two meshes share have the same bits and project to the
// same point (watertight).
namespace limen::world {

inline constexpr double kBlockSize = 192.0;         ///< side, metres
inline constexpr int kMapSize = 255;                ///< blocks each way
inline constexpr std::uint32_t kMostSprites = 8192; ///< in one dynamic state; further sprites are left out

/// A resident landblock.
struct Block {
    dat::BlockCoord coord;
    bool hasTerrain = false; ///< false for pure dungeons and for blocks without a LandBlock record
    std::vector<std::uint8_t> heightIndices; ///< 81, index x*9+y; empty without terrain
    std::vector<float> heights;              ///< 81 metres
    bool isFar = false;                      ///< its ground alone is resident
    [[nodiscard]] Vec3 origin() const { return {coord.x * kBlockSize, coord.y * kBlockSize, 0.0}; }
    friend bool operator==(const Block&, const Block&) = default;
};

/// A cell, or the outside.
struct Space {
    dat::RecordId cellId = 0;                           ///< 0 for outside
    std::uint32_t block = kNone;                        ///< index into blocks; kNone for outside
    std::uint32_t firstPortal = 0, portalCount = 0;     ///< its portals: a run of World::portals
    std::uint32_t firstInstance = 0, instanceCount = 0; ///< a run of World::spaceInstances: its members
    ZoneIndex zone = kNone;
    InstanceIndex shell = kNone; ///< the cell's own polygons; kNone for outside
    std::uint32_t lightSet = 0;  ///< index into lightSets: of objects without a set of their own
    bool seenOutside = false;    ///< the record's flag: its ambient light is that of the sky
    bool ofBuilding = false; ///< reached from a building portal: may contain a position found without history
    Vec3 origin{0.0};        ///< of the cell's own frame, global
    Aabb bounds;             ///< global; of the shell's and the portals' vertices
    std::uint32_t firstBspNode = 0,
                  bspNodeCount = 0; ///< a run of World::cellBspNodes; none: contains no point
    friend bool operator==(const Space&, const Space&) = default;
};

/// A node of a cell BSP in global coordinates. A point with signedDistance < -0.2 mm descends to `negative`
/// (kNone: it is outside the cell), other points to `positive` (kNone: inside). Children follow their parent.
/// docs/formats/cells.md#point-in-cell.
struct CellBspNode {
    Plane plane;
    std::uint32_t positive = kNone; ///< index relative to the space's firstBspNode
    std::uint32_t negative = kNone; ///< relative to firstBspNode, too; only in cells that are not convex
    friend bool operator==(const CellBspNode&, const CellBspNode&) = default;
};

/// An opening that leads out of `space`. The outside's portals are its buildings' portals, with the polygon
/// of the cell's exit portal (docs/ray-rule.md: one opening, the cell's polygon is used both ways).
struct Portal {
    SpaceIndex space = kNone;
    SpaceIndex destination = kNone; ///< kNone: not resident, or the record names none
    PortalIndex reciprocal = kNone; ///< the way back; kNone: one-way
    /// A run of World::portalVertices, counter-clockwise seen from inside `space`. For drawing.
    std::uint32_t firstVertex = 0, vertexCount = 0;
    /// A run of World::portalCorners: the convex hull, a subset of the vertices without those inserted into
    /// edges. For decisions.
    std::uint32_t firstCorner = 0, cornerCount = 0;
    Plane plane;                 ///< global; `space` is on the positive side
    std::uint32_t block = kNone; ///< the block whose local frame its vertices are exact in
    std::uint16_t recordIndex =
        0; ///< index in the cell's portal list; of the outside's portals: in the building's
    std::uint16_t polygonId = 0; ///< in the CellStruct
    bool exact = true;           ///< false: both polygons bound the opening
    /// Its polygon is an opaque surface of `space`. Rays and membership do not pass, bodies do.
    bool walled = false;
    /// An opening that is not flat is cut into triangles, each a portal (world/OpeningParts.h). The number among
    /// them, and theirs; they follow each other in World::portals.
    std::uint16_t part = 0, partCount = 1;
    std::uint32_t whole = kNone; ///< index into World::wholes; kNone: the portal is a whole opening
    friend bool operator==(const Portal&, const Portal&) = default;
};

/// Connected, closed and pairwise disjoint cells. Within a zone, depth alone decides visibility
/// (docs/ray-rule.md).
struct Zone {
    std::uint32_t firstSpace = 0, spaceCount = 0; ///< a run of World::zoneSpaces
    friend bool operator==(const Zone&, const Zone&) = default;
};

enum class InstanceKind : std::uint8_t { Shell, Terrain, Exterior, Scenery, Static, Dynamic, Filling, Sky };

enum class SurfaceClass : std::uint8_t { Opaque, CutOut, Blended };

/// One vertex of a mesh. Polygons do not share vertices.
struct MeshVertex {
    Vec3f position{
        0.0f}; ///< the corner to the nearest float, metres; block-local in shells, exteriors and terrain,
               ///< else in model space
    Vec3f normal{0.0f};
    Vec2f uv{
        0.0f}; ///< v grows downwards; of terrain: position in the landcell, (0,0) at its south-west corner
    /// Number of the polygon in its mesh, 0..polygonCount-1. Both sides of a two-sided polygon have the same
    /// number.
    std::uint16_t polygon = 0;
    std::uint16_t surface = 0; ///< slot in the instance's material run; of terrain: landcell 0..63 (cx*8+cy)
    Vec3f facet{0.0f};         ///< unit normal of its triangle; zero if that has no area
    /// Of shells: the facet of the polygon beyond the edge from here to the next corner, divided by a
    /// distance in metres. Surfaces of another cell may be within that distance of the facet's plane, because
    /// corners are inexact. Zero: no polygon beyond the edge.
    Vec3f neighbour{0.0f};
    /// Of shells, exteriors and fillings: the corner minus `position`.
    Vec3f rest{0.0f};

    /// The exact corner, in the space of `position`.
    [[nodiscard]] Vec3 corner() const { return TwoFloats{position, rest}.sum(); }
    void placeAt(const Vec3& corner) {
        const TwoFloats parts = inTwoFloats(corner);
        position = parts.nearest;
        rest = parts.rest;
    }
    friend bool operator==(const MeshVertex&, const MeshVertex&) = default;
};

/// Geometry that instances share. Triangles are counter-clockwise seen from the front. Back faces are never
/// drawn; a two-sided polygon is in the mesh twice. No two triangles share a vertex: vertices 3n, 3n+1 and
/// 3n+2 are the corners of one, in order.
struct Mesh {
    struct Range {
        std::uint32_t firstIndex = 0, indexCount = 0;
        friend bool operator==(const Range&, const Range&) = default;
    };
    std::uint64_t contentKey = 0; ///< identifies its source, e.g. a GfxObj
    std::uint32_t firstVertex = 0, vertexCount = 0;
    std::array<Range, 3> ranges{};     ///< by SurfaceClass; indices are relative to firstVertex
    std::uint32_t splitIndexCount = 0; ///< the first blended indices, of surfaces with Material::kSplit
    std::uint32_t polygonCount = 0;
    std::uint32_t firstPolygonInfo =
        0;         ///< run of World::polygonIds: the polygon's id in its record, by number
    Sphere bounds; ///< model space, of the vertices
    friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// A placement of a mesh: a shell, a building exterior, a block's terrain, or one part of an object.
struct Instance {
    static constexpr std::size_t kMostMembers = 0xFFFF;
    InstanceKind kind = InstanceKind::Static;
    Facing facing = Facing::Fixed; ///< `linear` is that of the part; DynamicState has the turned one
    std::uint16_t memberCount = 0;
    std::uint32_t firstMember = 0; ///< World::members: the memberCount spaces it belongs to, placedIn first
    SpaceIndex placedIn = kNone;
    dat::RecordId record = 0; ///< GfxObj, EnvCell (shell) or LandBlock (terrain) id
    std::uint64_t object = 0; ///< identity: parts of one object share it; unique across landblocks
    std::uint32_t idBase = 0; ///< its polygons have ids idBase .. idBase + polygonCount - 1; never 0 or 1
    std::uint32_t mesh = kNone;
    std::uint32_t firstMaterial =
        0;                ///< run of World::materialRefs by surface slot; for terrain: run of terrainCells
    float opacity = 1.0f; ///< multiplies that of its blended surfaces
    std::uint32_t level = kNone; ///< index into levels: one level of detail of several; kNone: it is alone
    std::uint32_t block = kNone; ///< the block that its placement is relative to
    glm::mat3 linear{1.0f};      ///< block-local from model: rotation and scale
    Vec3f origin{0.0f};          ///< block-local
    Sphere bounds;               ///< global

    /// Members beyond kMostMembers are dropped.
    void setMembers(std::uint32_t first, std::size_t count) {
        firstMember = first;
        memberCount = static_cast<std::uint16_t>(std::min(count, kMostMembers));
    }
    friend bool operator==(const Instance&, const Instance&) = default;
};
static_assert(sizeof(Instance) == 128, "two cache lines");

/// The appearance of a surface.
struct Material {
    static constexpr std::uint32_t kClamp = 1, kAdditive = 2, kInvAlpha = 4, kAlpha = 8;
    /// Blended by its picture's alpha alone. Its nearly opaque texels may be drawn in the solid stage.
    static constexpr std::uint32_t kSplit = 16;
    /// Its picture has a palette: as a cut-out it is tested against a lower alpha.
    static constexpr std::uint32_t kIndexed = 32;
    std::uint32_t texture = kNone; ///< index into textures; kNone: colour alone
    SurfaceClass surfaceClass = SurfaceClass::Opaque;
    std::uint32_t flags = 0;
    Vec4f colour{1.0f};      ///< white with a texture; alpha = 1 - translucency
    float luminosity = 0.0f; ///< emitted light, 0..1
    float diffuse = 1.0f;    ///< 0..1; counts by Readings::surfaceDiffuse alone
    dat::RecordId surface = 0;
    friend bool operator==(const Material&, const Material&) = default;
};

/// The textures of one landcell: the base, then overlays and roads, blended by alpha maps. Alpha 1 keeps the
/// layer beneath. docs/formats/landscape.md#texture-blending.
struct TerrainCell {
    struct Layer {
        std::uint32_t texture = kNone; ///< index into textures; kNone: no such layer
        std::uint32_t alpha = kNone;   ///< index into textures
        std::uint32_t rotation = 0;    ///< quarter turns of the alpha map, 0..3
        float tiling = 1.0f;           ///< repeats per landcell
        friend bool operator==(const Layer&, const Layer&) = default;
    };
    Layer base;
    std::array<Layer, 3> overlays;
    std::array<Layer, 2> roads; ///< both have the same road texture; their alphas multiply
    std::uint32_t split = 0;    ///< 1: diagonal from SW to NE, 0: from SE to NW
    friend bool operator==(const TerrainCell&, const TerrainCell&) = default;
};

/// A grain that is repeated over surfaces near the eye (docs/formats/textures.md#detail-pictures).
struct DetailPicture {
    std::uint32_t texture = kNone; ///< index into textures; kNone: no grain
    float tiling = 0.0f;           ///< repeats for each repeat of the surface's own picture, or landcell
    friend bool operator==(const DetailPicture&, const DetailPicture&) = default;
};
struct Details {
    DetailPicture land, exteriors, shells;
    friend bool operator==(const Details&, const Details&) = default;
};

/// A lamp in a cell. Lamps outdoors light nothing.
struct Light {
    Vec3 position{0.0};     ///< global
    Vec3f colour{1.0f};     ///< 0..1
    float intensity = 1.0f; ///< factor of the colour
    float falloff = 0.0f;   ///< metres; lamps reach a multiple of it
    friend bool operator==(const Light&, const Light&) = default;
};

/// The lamps that light some instances, and the way they do (docs/formats/light.md#lamps).
struct LightSet {
    enum class Kind : std::uint32_t {
        Outdoors, ///< sun and sky, no lamps
        Moving,   ///< of a cell: lamps that reach it. Each counts for the objects near it.
        Thing,    ///< of a static object in cells: at most 8 lamps, the nearest first
        Walls     ///< of a cell's shell: lamps are baked into its vertices
    } kind = Kind::Outdoors;
    bool sealed = false;                        ///< of cells that do not see the outside
    std::uint32_t firstLamp = 0, lampCount = 0; ///< run of World::lampRefs
    friend bool operator==(const LightSet&, const LightSet&) = default;
};

/// A defect of the data that does not prevent drawing.
struct Finding {
    dat::RecordId record = 0;
    std::string what;
    friend bool operator==(const Finding&, const Finding&) = default;
};

struct World {
    Readings readings; ///< of the records that it was made from
    std::vector<Block> blocks;
    std::vector<Space> spaces;
    std::vector<Portal> portals;
    std::vector<Portal> wholes; ///< the polygons of openings that are cut into parts; without a reciprocal
    std::vector<Vec3> portalCorners; ///< global; a subset of portalVertices, bit for bit
    std::vector<Vec3>
        portalVertices; ///< global; minus the origin of the portal's block: corners of its meshes
    std::vector<Zone> zones;
    std::vector<SpaceIndex> zoneSpaces;
    std::vector<CellBspNode> cellBspNodes;

    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint16_t> polygonIds;
    std::vector<Mesh> meshes;

    std::vector<Instance> instances;
    std::vector<Level> levels; ///< of moving parts: without `origin` and `measure`
    std::vector<Billboard> billboards;
    std::vector<SpaceIndex> members;
    std::vector<InstanceIndex> spaceInstances; ///< by space; shells first
    std::vector<Material> materials;
    std::vector<std::uint32_t> materialRefs; ///< indices into materials
    std::vector<TerrainCell> terrainCells;
    Details details;
    std::vector<std::shared_ptr<const Image>> textures; ///< never null; worlds of one cache share them
    std::vector<Light> lights;
    std::vector<std::uint32_t> lampRefs; ///< indices into lights
    std::vector<LightSet> lightSets;
    /// By instance: index into lightSets, in cells only; kNone, and beyond the end: that of its space.
    std::vector<std::uint32_t> instanceLightSets;
    Sky sky;

    // Dynamic objects. Their parts are instances in the object's frame; DynamicState sets block, members and
    // placedIn.
    std::vector<Instance> movingParts;
    std::vector<PosedPart> posedParts;
    std::vector<Cycle> cycles;
    std::vector<Stretch> stretches;
    std::vector<PartFrame> partFrames; ///< by frame, then by part
    std::vector<Door> doors;
    std::vector<Leaf> leaves;
    std::vector<LeafKey> leafKeys;
    std::vector<Route> routes;
    std::vector<RoutePoint> routePoints;
    std::vector<Villager> villagers;
    std::vector<Emitter> emitters;
    Player player;
    std::vector<IdleObject> idleObjects;
    std::vector<PlacedObject> placed;
    std::vector<ParticleStyle> particleStyles;
    std::vector<ParticleSource> particleSources;
    std::vector<LooseObject> looseObjects;
    std::uint32_t rainDrop = kNone; ///< movingParts: a unit square in the colour of rain
    std::uint32_t spriteIds = 0;    ///< the first of kMostSprites ids for sprites

    std::vector<Finding> findings;
    std::uint32_t idEnd = 2; ///< one past the last id in use
};

/// A portal's outline for drawing, with every vertex that other polygons have on its edges: global,
/// counter-clockwise seen from inside its space. Inserted vertices are up to 0.2 mm off its edges, so it is
/// only nearly convex.
[[nodiscard]] inline std::span<const Vec3> polygonOf(const World& world, const Portal& portal) {
    return std::span<const Vec3>(world.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
}

/// A portal's polygon for decisions: exactly convex, with the winding of polygonOf.
[[nodiscard]] inline std::span<const Vec3> cornersOf(const World& world, const Portal& portal) {
    return std::span<const Vec3>(world.portalCorners).subspan(portal.firstCorner, portal.cornerCount);
}

} // namespace limen::world
