#include "gpu/texture/TextureStaging.h"

#include "gpu/DriverChoices.h"
#include "gpu/texture/AtlasStaging.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

TextureClass classOf(const frame::TextureUpload& picture) {
    return {picture.width, picture.height, picture.clamp};
}

std::vector<MipLevel> levelsFor(const frame::TextureUpload& picture, const TextureClass& stored) {
    if (picture.width == stored.width && picture.height == stored.height)
        return mipChain(picture.width, picture.height, picture.rgba);
    const MipLevel large = enlarged(picture.width, picture.height, picture.rgba, stored.width, stored.height);
    return mipChain(large.width, large.height, large.rgba);
}

/// Filtering of all textures.
struct Filter {
    float anisotropy = 1.0f;
    bool nearestLevel = false;
};

TextureShape shapeOf(const TextureClass& size, std::uint32_t layers, const Filter& filter) {
    return {size.width,        size.height,        layers, mipLevelCount(size.width, size.height), size.clamp,
            filter.anisotropy, filter.nearestLevel};
}

bool isAmong(std::span<const TextureContent> before, const TextureContent& content) {
    return content.isKnown() && std::find(before.begin(), before.end(), content) != before.end();
}

/// Pages for the pictures of `order`.
PageLayout layOut(std::span<const frame::TextureUpload> pictures, std::span<const std::uint32_t> order,
                  std::uint32_t maxPages, std::uint32_t maxLayers, std::span<const TextureContent> before) {
    std::vector<TextureClass> classes, pages;
    for (const std::uint32_t picture : order)
        classes.push_back(classOf(pictures[picture]));
    for (const TextureContent& content : before)
        if (!content.isAtlas)
            pages.push_back({content.shape.width, content.shape.height, content.shape.clamp});
    PageLayout layout = layOutPages(classes, maxPages, maxLayers, pages);
    std::vector<TextureLocation> locations(pictures.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        locations[order[i]] = layout.locations[i];
    layout.locations = std::move(locations);
    return layout;
}

Result<void> stagePages(std::span<const frame::TextureUpload> pictures, const TextureStoreOptions& options,
                        const Capabilities& capabilities, const Filter& filter,
                        std::span<const TextureContent> before, StagedTextures& out) {
    const auto first = static_cast<std::uint32_t>(out.textures.size()); // 1 after an atlas
    const std::uint32_t units = capabilities.textureUnits - frame::gpu::kUnitFirstPage;
    const std::uint32_t maxPages =
        (options.pageLimit == 0 ? units : std::min(units, options.pageLimit)) - first;
    std::vector<std::uint32_t> order = orderByContent(pictures);
    std::erase_if(order, [&](std::uint32_t picture) { return !out.paged[picture]; });
    PageLayout layout = layOut(pictures, order, maxPages, capabilities.maxArrayLayers, before);
    if (layout.pages.size() > maxPages) {
        return fail(ErrorCode::Unsupported, capabilities.renderer,
                    fmt::format("cannot hold {} textures in {} pages of {} layers; choose a smaller --radius",
                                pictures.size(), maxPages, capabilities.maxArrayLayers));
    }
    for (const PageLayout::Page& page : layout.pages) {
        StagedTexture& texture = out.textures.emplace_back();
        texture.label = fmt::format("page {}x{}{}", page.shape.width, page.shape.height,
                                    page.shape.clamp ? " clamped" : "");
        texture.content.shape = shapeOf(page.shape, std::max(page.layers, 1u), filter);
        texture.content.keys.resize(page.layers);
    }
    out.resampled = layout.resampled;
    for (const std::uint32_t i : order) {
        const auto [page, layer] = layout.locations[i];
        out.locations[i] = {page + first, layer};
        out.textures[page + first].content.keys[layer] = pictures[i].contentKey;
        out.stored[i] = layout.pages[page].shape;
    }
    return {};
}

void stageHandles(std::span<const frame::TextureUpload> pictures, const Filter& filter, StagedTextures& out) {
    for (const frame::TextureUpload& picture : pictures) {
        const auto number = static_cast<std::uint32_t>(out.textures.size());
        StagedTexture& texture = out.textures.emplace_back();
        texture.label = fmt::format("texture {}", number);
        texture.content = {shapeOf(classOf(picture), 1, filter), {picture.contentKey}};
        out.locations[number] = {number, 0};
    }
}

} // namespace

std::vector<std::uint32_t> orderByContent(std::span<const frame::TextureUpload> pictures) {
    std::vector<std::uint32_t> order(pictures.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return pictures[a].contentKey < pictures[b].contentKey;
    });
    return order;
}

TextureBinding bindingFor(const StagedTextures& staged, std::span<const std::uint32_t> pictures) {
    TextureBinding binding{staged.bindless, 0, {}, staged.byIndex};
    if (staged.bindless)
        return binding;
    if (staged.hasAtlas())
        binding.atlas =
            AtlasPage{0, staged.textures[0].content.shape.width, staged.textures[0].content.shape.height};
    binding.pageCount = static_cast<std::uint32_t>(staged.textures.size());
    std::vector<bool> used(staged.textures.size(), false);
    for (const std::uint32_t picture : pictures)
        if (picture != frame::gpu::kNoTexture && staged.paged[picture])
            used[staged.locations[picture].page] = true;
    for (std::uint32_t page = 0; page < binding.pageCount; ++page)
        if (used[page])
            binding.pages.push_back(page);
    return binding;
}

bool TextureContent::isKnown() const {
    return std::find(keys.begin(), keys.end(), 0u) == keys.end();
}

Result<StagedTextures> stageTextures(std::span<const frame::TextureUpload> pictures,
                                     const TextureStoreOptions& options, const Capabilities& capabilities,
                                     std::span<const TextureContent> before, const TextureUses* uses) {
    if (options.mode == TextureMode::Bindless && !capabilities.bindless) {
        return fail(ErrorCode::Unsupported, capabilities.renderer,
                    "has no GL_ARB_bindless_texture; use --textures pages");
    }
    RendererOptions renderer;
    renderer.textures = options;
    const DriverChoices choices = driverChoices(renderer, capabilities);
    const Filter filter{choices.anisotropy, choices.nearestLevel};
    StagedTextures out;
    out.bindless = choices.bindless;
    out.byIndex = choices.pagesByIndex;
    out.locations.resize(pictures.size());
    out.inAtlas.resize(pictures.size());
    out.paged.assign(pictures.size(), true);
    for (const frame::TextureUpload& picture : pictures)
        out.stored.push_back(classOf(picture));
    const bool hasUnits = capabilities.textureUnits >= frame::gpu::kUnitFirstPage + 3; // and two for pages
    if (uses != nullptr && hasUnits)
        stageAtlas(pictures, *uses, capabilities, out);
    if (out.bindless)
        stageHandles(pictures, filter, out);
    else if (Result<void> staged = stagePages(pictures, options, capabilities, filter, before, out); !staged)
        return Failure(staged.error());
    for (StagedTexture& texture : out.textures) {
        texture.isShared = isAmong(before, texture.content);
        texture.layers.resize(texture.isShared ? 0 : texture.content.shape.layers);
    }
    if (out.hasAtlas() && !out.textures[0].isShared)
        fillAtlas(pictures, out);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const auto [texture, layer] = out.locations[i];
        if (out.paged[i] && !out.textures[texture].isShared)
            out.textures[texture].layers[layer] = levelsFor(pictures[i], out.stored[i]);
    }
    return out;
}

} // namespace limen::gpu
