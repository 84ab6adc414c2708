#pragma once

#include "frame/GpuLayout.h"

#include <span>
#include <string>
#include <vector>

namespace limen::frame {

/// A texture to upload: R,G,B,A bytes, top row first.
struct TextureUpload {
    std::uint32_t width = 0, height = 0;
    std::span<const std::uint8_t> rgba;
    bool clamp = false;           ///< sampled with clamp-to-edge, else repeat
    std::uint64_t contentKey = 0; ///< textures with equal keys have equal content; 0: unknown
};

/// Detail pictures of a scene: indices of textures, kNoTexture for none.
struct SceneDetails {
    std::uint32_t land = gpu::kNoTexture, exteriors = gpu::kNoTexture, shells = gpu::kNoTexture;
};

/// All static content in the GPU's layout, written once when it becomes resident. `textures` are views into
/// the world that the upload was made from and must not outlive it; the other arrays are owned.
struct SceneUpload {
    std::vector<gpu::Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< into `vertices`, of every mesh
    std::vector<gpu::Instance> instances;
    std::vector<gpu::Level> levels;     ///< that instances refer to
    std::vector<gpu::Member> members;   ///< those of the spaces first (frame/PackInstance.h)
    std::vector<gpu::DrawPiece> pieces; ///< of the instances (frame/ResidentPieces.h)
    std::vector<gpu::Material> materials;
    std::vector<std::uint32_t> materialRefs;
    std::vector<gpu::TerrainCell> terrainCells;
    std::vector<gpu::LightSet> lightSets;
    std::vector<std::uint32_t> lampRefs; ///< indices into FramePlan::lamps
    std::uint32_t lamps = 0;             ///< size of FramePlan::lamps
    std::vector<TextureUpload> textures;
    SceneDetails details;
    std::vector<std::string> defines; ///< macros of the programs that draw it (frame/ReadingDefines.h)
};

} // namespace limen::frame
