#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../../shaders/include/SharedLayout.h"

namespace limen::frame::gpu {

/// One vertex of the arena as the vertex fetch reads it. Three consecutive vertices are a triangle
/// (world::Mesh).
struct Vertex {
    glm::vec3 position{0.0f};
    std::uint32_t normal = 0; ///< signed normalised 10-10-10-2
    glm::vec2 uv{0.0f};
    std::uint32_t polygonSurface = 0; ///< polygon, and in the high half the surface slot
    glm::vec3 facet{0.0f};            ///< model-space unit normal of its triangle; zero if that has no area
    glm::vec3 neighbour{
        0.0f};            ///< of a shell: the wall beyond the edge to the next corner (world::MeshVertex)
    glm::vec3 rest{0.0f}; ///< residual of `position` (world::MeshVertex)
};

/// glMultiDrawElementsIndirect's command. `baseInstance` is the instance's index. Indices are of the arena,
/// so `baseVertex` is 0.
struct DrawCommand {
    std::uint32_t indexCount = 0;
    std::uint32_t instanceCount = 1;
    std::uint32_t firstIndex = 0;
    std::int32_t baseVertex = 0;
    std::uint32_t baseInstance = 0;
};

[[nodiscard]] constexpr std::uint32_t memberCountOf(const Instance& instance) {
    return instance.membersAndKind & kMostMembers;
}

[[nodiscard]] constexpr std::uint32_t kindOf(const Instance& instance) {
    return instance.membersAndKind >> 16;
}

/// The point of a pixel with one sample that its ray passes through: pixels from the centre, y downwards.
inline constexpr glm::dvec2 kPixelPlace{double{kBesideX} / kPartsOfAPixel,
                                        -double{kBesideY} / kPartsOfAPixel};

// Offsets of members: GpuLayoutOffsets.cpp.
static_assert(sizeof(Vertex) == 64 && sizeof(DrawCommand) == 20);
static_assert(sizeof(Visit) == 32 && sizeof(Instance) == 80 && sizeof(Member) == 8 && sizeof(Material) == 32);
static_assert(sizeof(TextureRef) == 16 && sizeof(TerrainLayer) == 16 && sizeof(TerrainCell) == 96);
static_assert(sizeof(LightSet) == 16 && sizeof(OwnershipVertex) == 48 && sizeof(ClipSet) == 128);
static_assert(sizeof(Level) == 16 && sizeof(SkyInstance) == 80 && sizeof(DrawPiece) == 16 &&
              sizeof(DrawRun) == 16 && sizeof(SlotGroup) == 16 && sizeof(Replacement) == 8 &&
              sizeof(DrawRecord) == 128 && sizeof(Lamp) == 32 && sizeof(PackedCell) == 96);
static_assert(sizeof(DrawCommand) == 4 * kWordsPerCommand &&
              kTrianglesPerPiece == kCullThreads * kTrianglesPerThread);

// Offsets in bytes, as std430 gives them.
static_assert(offsetof(ViewConstants, clipFromEye) == 0 && offsetof(ViewConstants, eyeHigh) == 64 &&
              offsetof(ViewConstants, eyeLow) == 80 && offsetof(ViewConstants, eyeSteps) == 96 &&
              offsetof(ViewConstants, sunDirection) == 112 && offsetof(ViewConstants, sunColour) == 128 &&
              offsetof(ViewConstants, landAmbient) == 144 && offsetof(ViewConstants, skyAmbient) == 160 &&
              offsetof(ViewConstants, sealedAmbient) == 176 && offsetof(ViewConstants, viewerLight) == 192 &&
              offsetof(ViewConstants, fogColour) == 208 && offsetof(ViewConstants, fogRange) == 224 &&
              offsetof(ViewConstants, voidColour) == 240 && offsetof(ViewConstants, skyZenith) == 256 &&
              offsetof(ViewConstants, detailTextures) == 272 &&
              offsetof(ViewConstants, detailTiling) == 288 && offsetof(ViewConstants, rootZone) == 304 &&
              offsetof(ViewConstants, visitCount) == 308 && offsetof(ViewConstants, flags) == 312 &&
              offsetof(ViewConstants, nearPlane) == 316 && offsetof(ViewConstants, staticInstances) == 320 &&
              offsetof(ViewConstants, staticMembers) == 324 && offsetof(ViewConstants, staticPieces) == 328 &&
              offsetof(ViewConstants, replacementCount) == 332 && sizeof(ViewConstants) == 336);
static_assert(offsetof(DeviceConstants, viewport) == 0 && offsetof(DeviceConstants, rayCorner) == 16 &&
              offsetof(DeviceConstants, rayRight) == 32 && offsetof(DeviceConstants, rayUp) == 48 &&
              offsetof(DeviceConstants, flags) == 64 && offsetof(DeviceConstants, pixel) == 68 &&
              offsetof(DeviceConstants, samplesX) == 72 && offsetof(DeviceConstants, samplesY) == 76 &&
              offsetof(DeviceConstants, firstBlock) == 80 && offsetof(DeviceConstants, firstVisit) == 84 &&
              offsetof(DeviceConstants, firstInstance) == 88 &&
              offsetof(DeviceConstants, firstMember) == 92 && offsetof(DeviceConstants, firstPiece) == 96 &&
              offsetof(DeviceConstants, firstReplacement) == 100 &&
              offsetof(DeviceConstants, firstRect) == 104 &&
              offsetof(DeviceConstants, firstSlotGroup) == 108 &&
              offsetof(DeviceConstants, firstRun) == 112 && offsetof(DeviceConstants, slotCount) == 116 &&
              offsetof(DeviceConstants, firstOccludee) == 120 &&
              offsetof(DeviceConstants, windowOrigin) == 124 && offsetof(DeviceConstants, firstLamp) == 128 &&
              sizeof(DeviceConstants) == 144);
static_assert(offsetof(FrameConstants, view) == 0 && offsetof(FrameConstants, device) == 336 &&
              sizeof(FrameConstants) == 480);

} // namespace limen::frame::gpu
