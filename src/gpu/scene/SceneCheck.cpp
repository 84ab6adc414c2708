#include "gpu/scene/SceneCheck.h"

#include <fmt/format.h>

namespace limen::gpu {
namespace {

using frame::SceneUpload;
namespace layout = frame::gpu;

Failure broken(const char* array, std::size_t entry, std::string what) {
    return fail(ErrorCode::BadArgument, fmt::format("{} {} of the scene", array, entry), std::move(what));
}

Result<void> checkInstances(const SceneUpload& scene) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const layout::Instance& instance = scene.instances[i];
        const std::uint32_t count = layout::memberCountOf(instance);
        const std::uint64_t end = std::uint64_t{instance.firstMember} + count;
        if (count == 0 || end > scene.members.size()) {
            return broken("instance", i,
                          fmt::format("has members {} to {} of {}; at least one is required",
                                      instance.firstMember, end, scene.members.size()));
        }
    }
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::uint32_t level = scene.instances[i].level;
        if (level != layout::kFromAnywhere && level >= scene.levels.size())
            return broken("instance", i,
                          fmt::format("has level of detail {} of {}", level, scene.levels.size()));
    }
    for (std::size_t i = 0; i < scene.members.size(); ++i) {
        if (scene.members[i].lightSet >= scene.lightSets.size()) {
            return broken(
                "member", i,
                fmt::format("has light set {} of {}", scene.members[i].lightSet, scene.lightSets.size()));
        }
    }
    return {};
}

Result<void> checkIndices(const SceneUpload& scene) {
    for (std::size_t i = 0; i < scene.indices.size(); ++i) {
        if (scene.indices[i] >= scene.vertices.size()) {
            return broken("index", i,
                          fmt::format("refers to vertex {} of {}", scene.indices[i], scene.vertices.size()));
        }
    }
    return {};
}

Result<void> checkPieces(const SceneUpload& scene) {
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const layout::DrawPiece& piece = scene.pieces[i];
        const std::uint64_t end = piece.firstIndex + std::uint64_t{3} * piece.triangles;
        if (piece.triangles > layout::kTrianglesPerPiece || end > scene.indices.size()) {
            return broken("piece", i,
                          fmt::format("has indices {} to {} of {}; at most {} are allowed", piece.firstIndex,
                                      end, scene.indices.size(), 3 * layout::kTrianglesPerPiece));
        }
        if (piece.instance >= scene.instances.size()) {
            return broken("piece", i,
                          fmt::format("refers to instance {} of {}", piece.instance, scene.instances.size()));
        }
        if (piece.indicesBefore != before) {
            return broken(
                "piece", i,
                fmt::format("has {} as the number of earlier indices, not {}", piece.indicesBefore, before));
        }
        before += 3 * piece.triangles;
    }
    return {};
}

Result<void> checkMaterials(const SceneUpload& scene) {
    for (std::size_t i = 0; i < scene.materialRefs.size(); ++i) {
        if (scene.materialRefs[i] >= scene.materials.size()) {
            return broken(
                "material reference", i,
                fmt::format("refers to material {} of {}", scene.materialRefs[i], scene.materials.size()));
        }
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const std::uint32_t texture = scene.materials[i].texture;
        if (texture != layout::kNoTexture && texture >= scene.textures.size())
            return broken("material", i, fmt::format("has texture {} of {}", texture, scene.textures.size()));
    }
    return {};
}

Result<void> checkDetails(const SceneUpload& scene) {
    const frame::SceneDetails& details = scene.details;
    for (const std::uint32_t texture : {details.land, details.exteriors, details.shells})
        if (texture != layout::kNoTexture && texture >= scene.textures.size())
            return broken("detail picture", texture,
                          fmt::format("is beyond the {} textures of the scene", scene.textures.size()));
    return {};
}

Result<void> checkTerrain(const SceneUpload& scene) {
    const auto isGood = [&](std::uint32_t texture) {
        return texture == layout::kNoTexture || texture < scene.textures.size();
    };
    // shaders do not read the map of an absent layer
    const auto layerIsGood = [&](const layout::TerrainLayer& layer) {
        return layer.texture == layout::kNoTexture || (isGood(layer.texture) && isGood(layer.alpha));
    };
    for (std::size_t i = 0; i < scene.terrainCells.size(); ++i) {
        const layout::TerrainCell& cell = scene.terrainCells[i];
        bool good = isGood(cell.base.texture);
        for (const layout::TerrainLayer& layer : cell.overlays)
            good = good && layerIsGood(layer);
        for (const layout::TerrainLayer& layer : cell.roads)
            good = good && layerIsGood(layer);
        if (!good) {
            return broken(
                "terrain cell", i,
                fmt::format("refers to a texture beyond the {} of the scene", scene.textures.size()));
        }
    }
    return {};
}

Result<void> checkLights(const SceneUpload& scene) {
    for (std::size_t i = 0; i < scene.lightSets.size(); ++i) {
        const layout::LightSet& set = scene.lightSets[i];
        const std::uint64_t end = std::uint64_t{set.firstLamp} + set.lampCount;
        if (end > scene.lampRefs.size())
            return broken(
                "light set", i,
                fmt::format("has lamp references {} to {} of {}", set.firstLamp, end, scene.lampRefs.size()));
    }
    for (std::size_t i = 0; i < scene.lampRefs.size(); ++i)
        if (scene.lampRefs[i] >= scene.lamps)
            return broken("lamp reference", i,
                          fmt::format("has lamp {} of {}", scene.lampRefs[i], scene.lamps));
    return {};
}

Result<void> checkTextures(const SceneUpload& scene) {
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const frame::TextureUpload& texture = scene.textures[i];
        if (texture.width == 0 || texture.height == 0 ||
            texture.rgba.size() != std::uint64_t{texture.width} * texture.height * 4) {
            return broken("texture", i,
                          fmt::format("has {}x{} pixels but {} bytes", texture.width, texture.height,
                                      texture.rgba.size()));
        }
    }
    return {};
}

} // namespace

Result<void> checkScene(const SceneUpload& scene) {
    return checkInstances(scene)
        .and_then([&] { return checkIndices(scene); })
        .and_then([&] { return checkPieces(scene); })
        .and_then([&] { return checkMaterials(scene); })
        .and_then([&] { return checkTerrain(scene); })
        .and_then([&] { return checkDetails(scene); })
        .and_then([&] { return checkLights(scene); })
        .and_then([&] { return checkTextures(scene); });
}

} // namespace limen::gpu
