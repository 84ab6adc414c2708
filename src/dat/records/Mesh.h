#pragma once

#include "core/SmallVec.h"
#include "dat/records/Primitives.h"

#include <optional>

// Vertices, polygons and BSP trees (docs/formats/geometry.md). Short lists are SmallVecs, most of which need no
// allocation, so a mesh decodes with a few allocations.
LIMEN_API_BEGIN
namespace limen::dat {

/// One vertex; `uvs` are indexed by the polygons that use it.
struct Vertex {
    Vec3f position{0.0f};
    Vec3f normal{0.0f};
    SmallVec<Vec2f, 2> uvs;
};

struct VertexArray {
    std::int32_t type = 1;
    std::vector<std::pair<std::uint16_t, Vertex>>
        vertices; ///< (key, vertex) in file order; keys are normally 0..n-1
};

/// `Polygon::sides`.
enum class Sides : std::int32_t { Single = 0, Double = 1, Both = 2 };

/// Stippling bits. None of them hides a polygon.
inline constexpr std::uint8_t kRepeatPositive = 1; ///< the positive side's picture repeats; clear: clamped
inline constexpr std::uint8_t kRepeatNegative = 2;
inline constexpr std::uint8_t kNoPositiveUv = 4;
inline constexpr std::uint8_t kNoNegativeUv = 8;

/// A convex polygon, counter-clockwise seen from its positive side.
struct Polygon {
    std::uint8_t stippling = 0;
    std::int32_t sides = 0;       ///< a Sides value; kept as stored, because files may hold others
    std::int16_t posSurface = -1; ///< index into the owner's surface list, -1 none
    std::int16_t negSurface = -1;
    SmallVec<std::uint16_t, 8> vertexKeys; ///< 3..255
    SmallVec<std::uint8_t, 8> posUv; ///< per vertex, index into its uvs; empty when stippling & kNoPositiveUv
    SmallVec<std::uint8_t, 8> negUv; ///< present iff sides == Both and !(stippling & kNoNegativeUv)
};

using PolygonList = std::vector<std::pair<std::uint16_t, Polygon>>; ///< (id, polygon) in file order

/// Four-character codes of BSP nodes, first letter in the most significant byte.
enum class BspTag : std::uint32_t {
    Leaf = 0x4C454146,
    Port = 0x504F5254,
    BPnn = 0x42506E6E,
    BPIn = 0x4250496E,
    BpIN = 0x4270494E,
    BpnN = 0x42706E4E,
    BPIN = 0x4250494E,
    BPnN = 0x42506E4E,
    BPOL = 0x42504F4C,
    BPFL = 0x4250464C
};

/// The kind of a tree, which determines the fields of its nodes.
enum class BspKind { Cell, Physics, Drawing };

/// A PORT node's reference to a portal of the building.
struct PortalRef {
    std::uint16_t polygonId = 0;
    std::uint16_t portalIndex = 0;
};

/// A node. Tag and kind determine the stored members (docs/formats/geometry.md#bsp-trees).
struct BspNode {
    BspTag tag = BspTag::Leaf;
    std::int32_t leafIndex = 0;
    std::int32_t solid = 0;
    PlaneF plane;
    SphereF sphere;
    std::int32_t positive = -1; ///< index into BspTree::nodes, -1 none
    std::int32_t negative = -1;
    SmallVec<std::uint16_t, 8> polygonIds;
    SmallVec<PortalRef, 2> portals;
};

/// A BSP tree as an array in file order; node 0 is the root. Empty means no tree.
struct BspTree {
    std::vector<BspNode> nodes;
};

} // namespace limen::dat
LIMEN_API_END
