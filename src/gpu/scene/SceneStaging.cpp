#include "gpu/scene/SceneStaging.h"

#include "gpu/DriverChoices.h"
#include "gpu/scene/PackedTerrain.h"
#include "gpu/scene/SceneCheck.h"
#include "gpu/scene/SharedVertices.h"

#include <algorithm>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

SceneBindings bindingsOf(const frame::SceneUpload& upload, const StagedTextures& textures,
                         const GroundTextures& ground) {
    std::vector<std::uint32_t> meshes;
    for (const layout::Material& material : upload.materials)
        meshes.push_back(material.texture);
    const frame::SceneDetails& details = upload.details;
    meshes.insert(meshes.end(), {details.exteriors, details.shells});
    std::vector<std::uint32_t> terrain = ground.colours;
    terrain.insert(terrain.end(), ground.maps.begin(), ground.maps.end());
    terrain.push_back(details.land);
    return {bindingFor(textures, meshes), bindingFor(textures, terrain),
            details.exteriors != layout::kNoTexture || details.shells != layout::kNoTexture,
            details.land != layout::kNoTexture, upload.defines};
}

TextureUses usesOf(const frame::SceneUpload& upload, const GroundTextures& ground) {
    const frame::SceneDetails& details = upload.details;
    TextureUses uses{ground.colours, {details.land}, {{details.exteriors, details.shells}}};
    uses.ground.insert(uses.ground.end(), ground.maps.begin(), ground.maps.end());
    for (const layout::Material& material : upload.materials)
        uses.meshes.push_back(material.texture);
    return uses;
}

/// Whether the previous pages keep their numbers.
bool keepsPageNumbers(std::span<const TextureContent> before, const StagedTextures& textures) {
    const auto isAlike = [](const TextureContent& a, const StagedTexture& b) {
        const TextureShape &one = a.shape, &other = b.content.shape;
        return a.isAtlas == b.content.isAtlas && one.width == other.width && one.height == other.height &&
               one.clamp == other.clamp;
    };
    return before.size() <= textures.textures.size() &&
           std::equal(before.begin(), before.end(), textures.textures.begin(), isAlike);
}

void include(const TextureBinding& before, TextureBinding& binding) {
    std::vector<std::uint32_t> pages;
    std::set_union(before.pages.begin(), before.pages.end(), binding.pages.begin(), binding.pages.end(),
                   std::back_inserter(pages));
    binding.pages = std::move(pages);
}

/// Keeps the pages of the ground of existing programs, if these can draw the scene otherwise: one without blend maps or without
/// ground has none of its own.
void keepGround(const TextureBinding& before, const GroundTextures& ground, const StagedTextures& textures,
                TextureBinding& binding) {
    const bool needsOthers = binding.pages != before.pages;
    if (!needsOthers && (!before.ground || areIn(*before.ground, ground, textures.locations)))
        binding.ground = before.ground;
}

} // namespace

Result<StagedScene> stageScene(frame::SceneUpload scene, const RendererOptions& options,
                               const Capabilities& capabilities, const SceneState& before) {
    if (Result<void> checked = checkScene(scene); !checked)
        return Failure(checked.error());
    const DriverChoices choices = driverChoices(options, capabilities);
    const GroundTextures ground = groundTexturesOf(scene.terrainCells);
    const TextureUses uses = usesOf(scene, ground);
    Result<StagedTextures> textures = stageTextures(scene.textures, options.textures, capabilities,
                                                    before.textures, choices.atlas ? &uses : nullptr);
    if (!textures)
        return Failure(textures.error());
    StagedScene staged;
    staged.bindings = bindingsOf(scene, *textures, ground);
    staged.packsTerrain = choices.packsTerrain && staged.bindings.terrain.pageCount > 0;
    if (staged.packsTerrain) {
        staged.blendMaps = partsOfMaps(scene.terrainCells, scene.textures);
        staged.bindings.terrain.ground = groundPagesOf(ground, textures->locations);
    }
    // Programs that can sample unneeded pages exist already; programs without them would have to be built.
    if (before.bindings && !textures->bindless && keepsPageNumbers(before.textures, *textures)) {
        include(before.bindings->meshes, staged.bindings.meshes);
        include(before.bindings->terrain, staged.bindings.terrain);
        keepGround(before.bindings->terrain, ground, *textures, staged.bindings.terrain);
    }
    scene.textures.clear();
    std::vector<std::uint32_t> shared;
    if (options.drawing == Drawing::Fast) {
        shared = shareVertices(scene.vertices, scene.indices);
        staged.tables = frame::tablesOf(scene);
    }
    staged.sharedIndices = std::make_shared<const std::vector<std::uint32_t>>(std::move(shared));
    staged.arrays = std::make_shared<const frame::SceneUpload>(std::move(scene));
    staged.textures = std::move(*textures);
    return staged;
}

} // namespace limen::gpu
