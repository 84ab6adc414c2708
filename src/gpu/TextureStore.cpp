#include "gpu/TextureStore.h"

#include "gpu/MipChain.h"
#include "gpu/PageLayout.h"

#include <utility>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

void writeLevels(Device& device, TextureHandle texture, std::uint32_t layer,
                 const std::vector<MipLevel>& levels) {
    for (std::uint32_t level = 0; level < levels.size(); ++level) {
        device.writeTexture(texture, layer, level, levels[level].width, levels[level].height,
                            levels[level].rgba);
    }
}

std::vector<MipLevel> levelsFor(const frame::TextureUpload& upload, const TextureClass& shape) {
    if (upload.width == shape.width && upload.height == shape.height) {
        return mipChain(upload.width, upload.height, upload.rgba);
    }
    const MipLevel large = enlarged(upload.width, upload.height, upload.rgba, shape.width, shape.height);
    return mipChain(large.width, large.height, large.rgba);
}

frame::gpu::TextureRef makeRef(std::uint32_t x, std::uint32_t y, const TextureClass& shape) {
    return {{x, y, shape.width | (shape.clamp ? frame::gpu::kTextureClamp : 0u), shape.height}};
}

} // namespace

Result<TextureStore> TextureStore::create(Device& device, std::span<const frame::TextureUpload> textures,
                                          const TextureStoreOptions& options) {
    const Capabilities& capabilities = device.capabilities();
    if (options.mode == TextureMode::Bindless && !capabilities.bindless) {
        return fail(ErrorCode::Unsupported, capabilities.renderer,
                    "the driver has no GL_ARB_bindless_texture; use array pages");
    }
    const float anisotropy = capabilities.software ? 1.0f : options.anisotropy;
    TextureStore store(device, options.mode != TextureMode::ArrayPages && capabilities.bindless);
    const Result<void> filled = store.bindless_ ? store.fillHandles(textures, anisotropy)
                                                : store.fillPages(textures, options, anisotropy);
    if (!filled) {
        return tl::unexpected(filled.error());
    }
    return store;
}

TextureStore::TextureStore(TextureStore&& other) noexcept
    : device_(other.device_), bindless_(other.bindless_), textures_(std::exchange(other.textures_, {})),
      refs_(std::exchange(other.refs_, {})), resampled_(other.resampled_) {}

TextureStore& TextureStore::operator=(TextureStore&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(bindless_, other.bindless_);
    std::swap(textures_, other.textures_);
    std::swap(refs_, other.refs_);
    std::swap(resampled_, other.resampled_);
    return *this;
}

TextureStore::~TextureStore() {
    if (bindless_ && !refs_.empty()) {
        device_->finishFrames();
        for (std::size_t i = 0; i < refs_.size(); ++i) { // the last texture may have got none
            device_->releaseHandle(textures_[i]);
        }
    }
    for (TextureHandle texture : textures_) {
        device_->destroyTexture(texture);
    }
}

std::span<const TextureHandle> TextureStore::pages() const {
    return bindless_ ? std::span<const TextureHandle>{} : std::span<const TextureHandle>{textures_};
}

TextureBinding TextureStore::bindingFor(std::span<const std::uint32_t> textures) const {
    TextureBinding binding{bindless_, 0, {}};
    if (bindless_) {
        return binding;
    }
    binding.pageCount = static_cast<std::uint32_t>(textures_.size());
    std::vector<bool> used(textures_.size(), false);
    for (const std::uint32_t texture : textures) {
        if (texture != frame::gpu::kNoTexture) {
            used[refs_[texture].place.y] = true;
        }
    }
    for (std::uint32_t page = 0; page < binding.pageCount; ++page) {
        if (used[page]) {
            binding.pages.push_back(page);
        }
    }
    return binding;
}

Result<void> TextureStore::fillPages(std::span<const frame::TextureUpload> textures,
                                     const TextureStoreOptions& options, float anisotropy) {
    const Capabilities& capabilities = device_->capabilities();
    const std::uint32_t units = capabilities.textureUnits - frame::gpu::kUnitFirstPage;
    const std::uint32_t maxPages = options.pageLimit == 0 ? units : std::min(units, options.pageLimit);
    std::vector<TextureClass> classes;
    for (const frame::TextureUpload& upload : textures) {
        classes.push_back({upload.width, upload.height, upload.clamp});
    }
    const PageLayout layout = layOutPages(classes, maxPages, capabilities.maxArrayLayers);
    if (layout.pages.size() > maxPages) {
        return fail(ErrorCode::Unsupported, capabilities.renderer,
                    fmt::format("{} textures are more than its {} pages of {} layers hold", textures.size(),
                                maxPages, capabilities.maxArrayLayers));
    }
    for (const PageLayout::Page& page : layout.pages) {
        const TextureShape shape{page.shape.width, page.shape.height,
                                 page.layers,      mipLevelCount(page.shape.width, page.shape.height),
                                 page.shape.clamp, anisotropy};
        const std::string label =
            fmt::format("page {}x{}{}", shape.width, shape.height, shape.clamp ? " clamped" : "");
        Result<TextureHandle> texture = device_->createTexture(label, shape);
        if (!texture) {
            return tl::unexpected(texture.error());
        }
        textures_.push_back(*texture);
    }
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const PageLayout::Place place = layout.places[i];
        const TextureClass& shape = layout.pages[place.page].shape;
        writeLevels(*device_, textures_[place.page], place.layer, levelsFor(textures[i], shape));
        refs_.push_back(makeRef(place.layer, place.page, shape));
    }
    resampled_ = layout.resampled;
    return {};
}

Result<void> TextureStore::fillHandles(std::span<const frame::TextureUpload> textures, float anisotropy) {
    for (const frame::TextureUpload& upload : textures) {
        const TextureShape shape{upload.width, upload.height, 1, mipLevelCount(upload.width, upload.height),
                                 upload.clamp, anisotropy};
        Result<TextureHandle> texture =
            device_->createTexture(fmt::format("texture {}", textures_.size()), shape);
        if (!texture) {
            return tl::unexpected(texture.error());
        }
        textures_.push_back(*texture);
        writeLevels(*device_, *texture, 0, mipChain(upload.width, upload.height, upload.rgba));
        const std::uint64_t handle = device_->residentHandle(*texture);
        if (handle == 0) {
            return fail(ErrorCode::Driver, device_->capabilities().renderer, "gives no handle for a texture");
        }
        refs_.push_back(makeRef(static_cast<std::uint32_t>(handle), static_cast<std::uint32_t>(handle >> 32),
                                {upload.width, upload.height, upload.clamp}));
    }
    return {};
}

} // namespace limen::gpu
