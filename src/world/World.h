#pragma once

#include "dat/Ids.h"
#include "geometry/Bounds.h"
#include "geometry/Plane.h"
#include "geometry/TwoFloats.h"
#include "world/Image.h"
#include "world/Index.h"
#include "world/LevelRange.h"
#include "world/Moving.h"
#include "world/Particles.h"
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
// Space: "global" is metres from the south-west corner of landblock 0x0000, x east, y north, z up, in double.
// "Block-local" is metres from the south-west corner of a landblock: everything static is stored so, in float, because
// 192 m in a float is exact to 0.02 mm anywhere on the map. Corners of what must meet (shells, exteriors, portals) are
// stored in two floats, whose sum is as exact as the data: else cells that touch would reach into each other by what the
// first float rounds. Those that two meshes share have the very same bits and so project to the same point (watertight).
namespace limen::world {

inline constexpr double kBlockSize = 192.0;
inline constexpr std::uint32_t kMostSprites = 8192; ///< in one moment; what exceeds them is left out

/// A resident landblock.
struct Block {
    dat::BlockCoord coord;
    bool hasTerrain = false; ///< false for pure dungeons and for blocks without a LandBlock record
    std::vector<std::uint8_t> heightIndices; ///< 81, index x*9+y; empty without terrain
    std::vector<float> heights;              ///< 81 metres
    bool isFar = false;                      ///< of it the ground alone is resident
    [[nodiscard]] Vec3 origin() const { return {coord.x * kBlockSize, coord.y * kBlockSize, 0.0}; }
    friend bool operator==(const Block&, const Block&) = default;
};

/// A cell, or the outside.
struct Space {
    dat::RecordId cellId = 0;                       ///< 0 for outside
    std::uint32_t block = kNone;                    ///< index into blocks; kNone for outside
    std::uint32_t firstPortal = 0, portalCount = 0; ///< its portals: a run of World::portals
    std::uint32_t firstInstance = 0,
                  instanceCount = 0; ///< a run of World::spaceInstances: instances that are members
    ZoneIndex zone = kNone;
    InstanceIndex shell = kNone; ///< the cell's own polygons; kNone for outside
    std::uint32_t lightSet = 0;  ///< index into lightSets
    bool seenOutside = false;    ///< the record's flag: light it by the sun as well
    bool ofBuilding = false; ///< reached from a building portal: may hold a position found without history
    Aabb bounds;             ///< global; of the shell's and the portals' vertices
    std::uint32_t firstBspNode = 0,
                  bspNodeCount = 0; ///< cell BSP in World::cellBspNodes; none: contains nothing
    friend bool operator==(const Space&, const Space&) = default;
};

/// A node of a cell BSP in global coordinates: for a point with signedDistance < -0.2 mm the walk goes on in `negative` (kNone: it is outside the
/// cell), else in `positive` (kNone: inside). Children follow their parent. formats/cells.md, "Point in cell".
struct CellBspNode {
    Plane plane;
    std::uint32_t positive = kNone; ///< index relative to the space's firstBspNode
    std::uint32_t negative = kNone; ///< likewise; of cells that are not convex
    friend bool operator==(const CellBspNode&, const CellBspNode&) = default;
};

/// An opening that leads out of `space`. The outside's portals are its buildings' portals, with the polygon of the
/// cell's exit portal (docs/ray-rule.md: one opening, the cell's polygon is used both ways).
struct Portal {
    SpaceIndex space = kNone;
    SpaceIndex destination = kNone; ///< kNone: not resident, or the data names nothing
    PortalIndex reciprocal = kNone; ///< the way back; kNone: one-way
    std::uint32_t firstVertex = 0,
                  vertexCount = 0; ///< World::portalVertices, counter-clockwise seen from inside `space`
    /// World::portalCorners: its convex hull, a subset of its vertices without those inserted into edges. For
    /// decisions.
    std::uint32_t firstCorner = 0, cornerCount = 0;
    Plane plane;                   ///< global; `space` lies on the positive side
    std::uint32_t block = kNone;   ///< the block whose local frame its vertices are exact in
    std::uint16_t recordIndex = 0; ///< index in the cell's portal list; for outside: in the building's
    std::uint16_t polygonId = 0;   ///< in the CellStruct
    bool exact = true;             ///< false: both polygons bound the opening
    friend bool operator==(const Portal&, const Portal&) = default;
};

/// Connected, closed and pairwise disjoint cells: depth alone decides what is in front inside one (docs/ray-rule.md).
struct Zone {
    std::uint32_t firstSpace = 0, spaceCount = 0; ///< a run of World::zoneSpaces
    friend bool operator==(const Zone&, const Zone&) = default;
};

enum class InstanceKind : std::uint8_t { Shell, Terrain, Exterior, Scenery, Static, Dynamic, Filling, Sky };

/// How a surface takes part in a frame.
enum class SurfaceClass : std::uint8_t { Opaque, CutOut, Blended };

/// One vertex of the arena. Vertices are not shared between polygons.
struct MeshVertex {
    Vec3f position{
        0.0f}; ///< model space; for shells, exteriors and terrain: block-local, to the nearest float
    Vec3f normal{0.0f};
    Vec2f uv{
        0.0f}; ///< v grows downwards; for terrain: position in the landcell, (0,0) at its south-west corner
    std::uint16_t polygon =
        0; ///< number of the polygon in its mesh, 0..polygonCount-1 (two-sided: one number for both sides)
    std::uint16_t surface = 0; ///< slot in the instance's material run; for terrain: landcell 0..63 (cx*8+cy)
    Vec3f facet{0.0f};         ///< unit normal of its triangle; zero if that has no area
    /// Of shells: facet of the polygon beyond the edge from here to the next corner, divided by the metres from its plane
    /// within which surfaces of another cell may lie for what corners are off; zero where none is.
    Vec3f neighbour{0.0f};
    /// Of shells, exteriors and fillings: what `position` is short of the corner.
    Vec3f rest{0.0f};

    /// The corner itself, in the space of `position`.
    [[nodiscard]] Vec3 corner() const { return TwoFloats{position, rest}.sum(); }
    void placeAt(const Vec3& corner) {
        const TwoFloats parts = inTwoFloats(corner);
        position = parts.nearest;
        rest = parts.rest;
    }
    friend bool operator==(const MeshVertex&, const MeshVertex&) = default;
};

/// Geometry that instances share. Triangles are counter-clockwise from the front; back faces are never drawn
/// (two-sided polygons are in twice). Vertices come in threes: no two triangles share one, and three that follow one another,
/// from a multiple of three on, are a triangle's corners in order.
struct Mesh {
    struct Range {
        std::uint32_t firstIndex = 0, indexCount = 0;
        friend bool operator==(const Range&, const Range&) = default;
    };
    std::uint64_t contentKey =
        0; ///< what it was made from, e.g. the GfxObj id; never depends on where the player is
    std::uint32_t firstVertex = 0, vertexCount = 0;
    std::array<Range, 3> ranges{}; ///< by SurfaceClass; indices are relative to firstVertex
    /// The first so many of the blended ones are of surfaces with Material::kSplit; they follow the cut-outs.
    std::uint32_t splitIndexCount = 0;
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
    std::uint16_t memberCount = 0;
    std::uint32_t firstMember = 0; ///< World::members: the memberCount spaces it belongs to, placedIn first
    SpaceIndex placedIn = kNone;
    dat::RecordId record = 0; ///< GfxObj, EnvCell (shell) or LandBlock (terrain) id
    std::uint64_t object = 0; ///< identity: parts of one object share it; unique across landblocks
    std::uint32_t idBase = 0; ///< its polygons have ids idBase .. idBase + polygonCount - 1; never 0 or 1
    std::uint32_t mesh = kNone;
    std::uint32_t firstMaterial =
        0;                 ///< run of World::materialRefs by surface slot; for terrain: run of terrainCells
    float opacity = 1.0f;  ///< multiplies that of its blended surfaces
    LevelRange levelRange; ///< distances at which it is drawn: one level of detail of several
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

/// What a surface looks like.
struct Material {
    static constexpr std::uint32_t kClamp = 1, kAdditive = 2, kInvAlpha = 4, kAlpha = 8;
    /// Blended by its picture's alpha alone: where that is nearly opaque it may be painted as what is solid.
    static constexpr std::uint32_t kSplit = 16;
    std::uint32_t texture = kNone; ///< index into textures; kNone: colour alone
    SurfaceClass surfaceClass = SurfaceClass::Opaque;
    std::uint32_t flags = 0;
    Vec4f colour{1.0f};      ///< of a solid surface, else white; alpha = 1 - translucency
    float luminosity = 0.0f; ///< light it always has, 0..1
    float diffuse = 1.0f;
    dat::RecordId surface = 0;
    friend bool operator==(const Material&, const Material&) = default;
};

/// How one landcell's ground is painted (formats/landscape.md §7): base, then overlays and roads through
/// alpha maps where 1 keeps what is underneath.
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
    std::array<Layer, 2> roads; ///< both in the same road texture; their alphas multiply
    std::uint32_t split = 0;    ///< 1: diagonal SW-NE, 0: SE-NW
    friend bool operator==(const TerrainCell&, const TerrainCell&) = default;
};

struct Light {
    Vec3 position{0.0}; ///< global
    Vec3f colour{1.0f}; ///< times intensity
    float range = 0.0f; ///< metres
    friend bool operator==(const Light&, const Light&) = default;
};

/// How a space is lit: sun and sky, or its own ambient, and the lamps that reach it.
struct LightSet {
    Vec3f ambient{0.0f};                          ///< added to the sky's times `sky`
    float sky = 1.0f;                             ///< share of the sky's ambient, 0..1
    float sun = 1.0f;                             ///< share of the sun, 0..1
    std::uint32_t firstLight = 0, lightCount = 0; ///< run of World::lights, at most 8, brightest first
    friend bool operator==(const LightSet&, const LightSet&) = default;
};

/// Something odd in the data that the picture copes with; said once.
struct Finding {
    dat::RecordId record = 0;
    std::string what;
    friend bool operator==(const Finding&, const Finding&) = default;
};

struct World {
    std::vector<Block> blocks;
    std::vector<Space> spaces;
    std::vector<Portal> portals;
    std::vector<Vec3> portalCorners; ///< global; some of portalVertices, to the bit
    std::vector<Vec3>
        portalVertices; ///< global; less the origin of the portal's block they are corners of its meshes
    std::vector<Zone> zones;
    std::vector<SpaceIndex> zoneSpaces;
    std::vector<CellBspNode> cellBspNodes;

    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint16_t> polygonIds;
    std::vector<Mesh> meshes;

    std::vector<Instance> instances;
    std::vector<SpaceIndex> members;
    std::vector<InstanceIndex> spaceInstances; ///< by space; shells first
    std::vector<Material> materials;
    std::vector<std::uint32_t> materialRefs; ///< indices into materials
    std::vector<TerrainCell> terrainCells;
    std::vector<std::shared_ptr<const Image>>
        textures; ///< never null; worlds that follow each other share them
    std::vector<Light> lights;
    std::vector<LightSet> lightSets;
    Sky sky;

    // What moves. Parts are instances in the frame of the thing they are part of; block, members and placedIn are the
    // moment's (world/DynamicState.h).
    std::vector<Instance> movingParts;
    std::vector<PosedPart> posedParts;
    std::vector<Cycle> cycles;
    std::vector<Stretch> stretches;
    std::vector<PartFrame> partFrames; ///< frame after frame, in each the parts in order
    std::vector<Door> doors;
    std::vector<Leaf> leaves;
    std::vector<Route> routes;
    std::vector<RoutePoint> routePoints;
    std::vector<Villager> villagers;
    std::vector<Emitter> emitters;
    Player player;
    std::vector<IdleObject> idleObjects;
    std::vector<ParticleStyle> particleStyles;
    std::vector<ParticleSource> particleSources;
    std::vector<LooseObject> looseObjects;
    std::uint32_t rainDrop = kNone; ///< movingParts: a unit square in the colour of rain
    std::uint32_t spriteIds = 0;    ///< the first of kMostSprites ids by which sprites count as layers

    std::vector<Finding> findings;
    std::uint32_t idEnd = 2; ///< one past the last id in use
};

/// The resident block with these coordinates, or null. Cost: a binary search.
[[nodiscard]] const Block* findBlock(const World& world, dat::BlockCoord coord);

/// A portal's outline as it is drawn, with every vertex that other polygons have on its edges: global,
/// counter-clockwise seen from inside its space. Inserted vertices lie up to 0.2 mm off its edges, so it is
/// only nearly convex.
[[nodiscard]] inline std::span<const Vec3> polygonOf(const World& world, const Portal& portal) {
    return std::span<const Vec3>(world.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
}

/// A portal's polygon for decisions: exactly convex, same winding as polygonOf.
[[nodiscard]] inline std::span<const Vec3> cornersOf(const World& world, const Portal& portal) {
    return std::span<const Vec3>(world.portalCorners).subspan(portal.firstCorner, portal.cornerCount);
}

} // namespace limen::world
