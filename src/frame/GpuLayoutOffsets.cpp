#include "frame/GpuLayout.h"

#include <cstddef>

// Offsets in bytes of every member of the structs that C++ writes and the GPU reads, so that a compiler with
// another layout fails here. tests/gpu/SharedLayoutGlTest.cpp compares them with the driver's.
namespace limen::frame::gpu {
namespace {

// Read as texels of 16 bytes, decoded by hand in shaders/include/buffers.glsl.
static_assert(offsetof(Vertex, position) == 0 && offsetof(Vertex, normal) == 12 &&
              offsetof(Vertex, uv) == 16 && offsetof(Vertex, polygonSurface) == 24 &&
              offsetof(Vertex, facet) == 28 && offsetof(Vertex, neighbour) == 40 &&
              offsetof(Vertex, rest) == 52);
static_assert(offsetof(Visit, entryPlane) == 0 && offsetof(Visit, zone) == 16 &&
              offsetof(Visit, parent) == 20 && offsetof(Visit, shutBy) == 24 &&
              offsetof(Visit, reserved) == 28);
static_assert(offsetof(Instance, pose0) == 0 && offsetof(Instance, pose1) == 16 &&
              offsetof(Instance, pose2) == 32 && offsetof(Instance, block) == 48 &&
              offsetof(Instance, idBase) == 52 && offsetof(Instance, firstMaterial) == 56 &&
              offsetof(Instance, firstMember) == 60 && offsetof(Instance, membersAndKind) == 64 &&
              offsetof(Instance, level) == 68 && offsetof(Instance, highlight) == 72 &&
              offsetof(Instance, opacity) == 76);
static_assert(offsetof(Member, zone) == 0 && offsetof(Member, lightSet) == 4);
static_assert(offsetof(DrawPiece, firstIndex) == 0 && offsetof(DrawPiece, triangles) == 4 &&
              offsetof(DrawPiece, instance) == 8 && offsetof(DrawPiece, indicesBefore) == 12);
static_assert(offsetof(RunOffsets, piece) == 0 && offsetof(RunOffsets, kept) == 4);
static_assert(offsetof(DrawRun, offsets) == 0 && offsetof(DrawRun, firstSlot) == 8 &&
              offsetof(DrawRun, rects) == 12);
static_assert(offsetof(SlotGroup, offsets) == 0 && offsetof(SlotGroup, firstRun) == 8 &&
              offsetof(SlotGroup, lastRun) == 12);
static_assert(offsetof(Replacement, instance) == 0 && offsetof(Replacement, by) == 4);
constexpr std::size_t kTexel = 16;
static_assert(sizeof(Vertex) == kVertexTexels * kTexel && sizeof(Instance) == kInstanceTexels * kTexel &&
              sizeof(Visit) == kVisitTexels * kTexel);
static_assert(sizeof(DrawPiece) == kTexel && sizeof(DrawRun) == kTexel && sizeof(SlotGroup) == kTexel &&
              2 * sizeof(Member) == kTexel && 2 * sizeof(Replacement) == kTexel);

// Read from storage buffers (std430).
static_assert(offsetof(Level, originX) == 0 && offsetof(Level, originY) == 4 &&
              offsetof(Level, originZ) == 8 && offsetof(Level, range) == 12);
static_assert(offsetof(Material, colour) == 0 && offsetof(Material, texture) == 16 &&
              offsetof(Material, flags) == 20 && offsetof(Material, luminosity) == 24 &&
              offsetof(Material, diffuse) == 28);
static_assert(offsetof(TextureRef, place) == 0);
static_assert(offsetof(TerrainLayer, texture) == 0 && offsetof(TerrainLayer, alpha) == 4 &&
              offsetof(TerrainLayer, rotation) == 8 && offsetof(TerrainLayer, tiling) == 12);
static_assert(offsetof(TerrainCell, base) == 0 && offsetof(TerrainCell, overlays) == 16 &&
              offsetof(TerrainCell, roads) == 64);
static_assert(offsetof(LightSet, kind) == 0 && offsetof(LightSet, firstLamp) == 4 &&
              offsetof(LightSet, lampCount) == 8 && offsetof(LightSet, sealed) == 12);
static_assert(offsetof(OwnershipVertex, position) == 0 && offsetof(OwnershipVertex, block) == 12 &&
              offsetof(OwnershipVertex, visit) == 16 && offsetof(OwnershipVertex, clipSet) == 20 &&
              offsetof(OwnershipVertex, outlineFirst) == 24 &&
              offsetof(OwnershipVertex, outlineCount) == 28 && offsetof(OwnershipVertex, rest) == 32 &&
              offsetof(OwnershipVertex, clipEdges) == 44);
static_assert(offsetof(ClipSet, planes) == 0 && sizeof(ClipSet) == (kLastClipPlane + 1) * sizeof(vec4));
static_assert(offsetof(SkyInstance, row0) == 0 && offsetof(SkyInstance, row1) == 16 &&
              offsetof(SkyInstance, row2) == 32 && offsetof(SkyInstance, firstMaterial) == 48 &&
              offsetof(SkyInstance, opacity) == 52 && offsetof(SkyInstance, luminosity) == 56 &&
              offsetof(SkyInstance, uvOffsetX) == 60 && offsetof(SkyInstance, uvOffsetY) == 64 &&
              offsetof(SkyInstance, diffuse) == 68 && offsetof(SkyInstance, overLand) == 72 &&
              offsetof(SkyInstance, clipSet) == 76);
static_assert(sizeof(TerrainCell) ==
              kLayersPerCell * sizeof(TerrainLayer)); // the shaders read an array of layers

// Read by glMultiDrawElementsIndirect, written as words by shaders/cull.comp.
static_assert(offsetof(DrawCommand, indexCount) == 0 && offsetof(DrawCommand, instanceCount) == 4 &&
              offsetof(DrawCommand, firstIndex) == 8 && offsetof(DrawCommand, baseVertex) == 12 &&
              offsetof(DrawCommand, baseInstance) == 16);

} // namespace
} // namespace limen::frame::gpu
