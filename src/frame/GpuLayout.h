#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../../shaders/include/SharedLayout.h"

namespace limen::frame::gpu {

/// One vertex of the arena as the vertex fetch reads it; 64 bytes. They come in threes (world::Mesh).
struct Vertex {
    glm::vec3 position{0.0f};
    std::uint32_t normal = 0; ///< signed normalised 10-10-10-2
    glm::vec2 uv{0.0f};
    std::uint32_t polygonSurface = 0; ///< polygon, and in the high half the surface slot
    glm::vec3 facet{0.0f};            ///< model-space unit normal of its triangle; zero if that has no area
    glm::vec3 neighbour{
        0.0f};            ///< of a shell: the wall beyond the edge to the next corner (world::MeshVertex)
    glm::vec3 rest{0.0f}; ///< what `position` is short of the corner (world::MeshVertex)
};

/// glMultiDrawElementsIndirect's command. `baseInstance` is the instance's index. Indices are of the arena, so `baseVertex` is 0.
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

/// Where in a pixel with one sample its ray passes: pixels from the centre, y downwards.
inline constexpr glm::dvec2 kPixelPlace{double{kBesideX} / kPartsOfAPixel,
                                        -double{kBesideY} / kPartsOfAPixel};

// Offsets of members: GpuLayoutOffsets.cpp.
static_assert(sizeof(Vertex) == 64 && sizeof(DrawCommand) == 20);
static_assert(sizeof(FrameConstants) == 64 + 14 * 16 + 96);
static_assert(sizeof(Visit) == 32 && sizeof(Instance) == 80 && sizeof(Member) == 8 && sizeof(Material) == 32);
static_assert(sizeof(TextureRef) == 16 && sizeof(TerrainLayer) == 16 && sizeof(TerrainCell) == 96);
static_assert(sizeof(LightSet) == 32 && sizeof(Light) == 32 && sizeof(OwnershipVertex) == 48 &&
              sizeof(ClipSet) == 128);
static_assert(sizeof(SkyInstance) == 80 && sizeof(DrawPiece) == 16 && sizeof(DrawRun) == 16 &&
              sizeof(SlotGroup) == 16 && sizeof(Replacement) == 8);
static_assert(sizeof(DrawCommand) == 4 * kWordsPerCommand &&
              kTrianglesPerPiece == kCullThreads * kTrianglesPerThread);

} // namespace limen::frame::gpu
