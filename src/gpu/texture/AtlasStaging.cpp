#include "gpu/texture/AtlasStaging.h"

#include <algorithm>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

/// Follow the key of each picture among an atlas' keys: the same pictures differ in their borders and places by them. Not 0.
constexpr std::uint64_t kRepeatedUse = 1, kClampedUse = 2, kFirstGrainUse = 3;

std::vector<bool> among(std::span<const std::uint32_t> pictures, std::size_t count) {
    std::vector<bool> out(count, false);
    for (const std::uint32_t picture : pictures)
        if (picture != layout::kNoTexture)
            out[picture] = true;
    return out;
}

/// Levels of a grain with kGrainSide texels a side. Those that are larger than the picture are enlarged; the others are its own
/// levels, which a filter of the enlarged ones would blur.
std::vector<MipLevel> grainLevels(const frame::TextureUpload& picture) {
    const std::vector<MipLevel> own = mipChain(picture.width, picture.height, picture.rgba);
    std::vector<MipLevel> levels;
    for (std::uint32_t side = kGrainSide; side >= 1; side /= 2)
        levels.push_back(resized(own, side, side));
    return levels;
}

} // namespace

void stageAtlas(std::span<const frame::TextureUpload> pictures, const TextureUses& uses,
                const Capabilities& capabilities, StagedTextures& out) {
    const std::vector<bool> onGround = among(uses.ground, pictures.size()),
                            onMeshes = among(uses.meshes, pictures.size()),
                            isGrain = among(uses.grains, pictures.size());
    const bool hasGrains = std::find(isGrain.begin(), isGrain.end(), true) != isGrain.end();
    std::vector<TextureClass> classes;
    std::vector<std::uint32_t> members;
    for (const std::uint32_t i : orderByContent(pictures)) {
        if (!onMeshes[i] && (onGround[i] || isGrain[i]))
            continue;
        members.push_back(i);
        classes.push_back({pictures[i].width, pictures[i].height, pictures[i].clamp});
    }
    const std::optional<AtlasLayout> layout =
        layOutAtlas(classes, hasGrains, capabilities.maxTextureSize, capabilities.maxArrayLayers);
    if (!layout)
        return;
    StagedTexture& atlas = out.textures.emplace_back();
    atlas.label = "atlas";
    atlas.content.isAtlas = true;
    atlas.content.shape = {
        .width = layout->width, .height = layout->height, .layers = layout->layers, .clamp = true};
    out.paged = onGround;
    for (std::size_t m = 0; m < members.size(); ++m) {
        out.inAtlas[members[m]] = AtlasEntry{classes[m], layout->spots[m]};
        const std::uint64_t use = classes[m].clamp ? kClampedUse : kRepeatedUse;
        atlas.content.keys.insert(atlas.content.keys.end(), {pictures[members[m]].contentKey, use});
    }
    for (std::size_t g = 0; g < uses.grains.size(); ++g) {
        out.grains[g] = uses.grains[g];
        if (uses.grains[g] != layout::kNoTexture)
            atlas.content.keys.insert(atlas.content.keys.end(),
                                      {pictures[uses.grains[g]].contentKey, kFirstGrainUse + g});
    }
}

void fillAtlas(std::span<const frame::TextureUpload> pictures, StagedTextures& out) {
    const TextureShape& shape = out.textures[0].content.shape;
    const MipLevel blank{shape.width, shape.height,
                         std::vector<std::uint8_t>(std::size_t{shape.width} * shape.height * 4)};
    std::vector<std::vector<MipLevel>>& layers = out.textures[0].layers;
    layers.assign(shape.layers, {blank});
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (!out.inAtlas[i])
            continue;
        const auto& [stored, spot] = *out.inAtlas[i];
        putIntoAtlas(mipChain(pictures[i].width, pictures[i].height, pictures[i].rgba), stored.clamp, spot,
                     layers[spot.layer][0]);
    }
    for (std::size_t g = 0; g < out.grains.size(); ++g)
        if (out.grains[g] != layout::kNoTexture)
            putIntoAtlas(grainLevels(pictures[out.grains[g]]), false, grainSpots()[g], layers[0][0]);
}

} // namespace limen::gpu
