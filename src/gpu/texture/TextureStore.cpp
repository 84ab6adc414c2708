#include "gpu/texture/TextureStore.h"

#include "core/Assert.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace limen::gpu {
namespace {

frame::gpu::TextureRef makeRef(std::uint32_t x, std::uint32_t y, const TextureClass& shape) {
    return {{x, y, shape.width | (shape.clamp ? frame::gpu::kTextureClamp : 0u), shape.height}};
}

} // namespace

ResidentTexture::~ResidentTexture() {
    if (handle_ != 0)
        device_.releaseHandle(texture_);
    device_.destroyTexture(texture_);
}

bool ResidentTexture::takeHandle() {
    handle_ = device_.residentHandle(texture_);
    return handle_ != 0;
}

Result<TextureStore> TextureStore::create(Device& device, std::span<const frame::TextureUpload> textures,
                                          const TextureStoreOptions& options) {
    Result<StagedTextures> staged = stageTextures(textures, options, device.capabilities(), {});
    if (!staged)
        return Failure(staged.error());
    TextureStore store(device, std::move(*staged), nullptr);
    std::size_t bytes = std::numeric_limits<std::size_t>::max();
    if (const Result<bool> filled = store.advance(bytes); !filled)
        return Failure(filled.error());
    return store;
}

TextureStore::TextureStore(Device& device, StagedTextures staged, const TextureStore* before)
    : device_(&device), staged_(std::move(staged)), shared_(staged_.textures.size()) {
    for (std::size_t i = 0; before != nullptr && i < shared_.size(); ++i) {
        const StagedTexture& wanted = staged_.textures[i];
        const auto isIt = [&](const auto& other) { return other->content() == wanted.content; };
        const auto& there = before->textures_;
        if (const auto found = std::find_if(there.begin(), there.end(), isIt);
            wanted.isShared && found != there.end())
            shared_[i] = *found;
    }
}

TextureStore::TextureStore(TextureStore&& other) noexcept
    : device_(other.device_), staged_(std::exchange(other.staged_, {})),
      shared_(std::exchange(other.shared_, {})), textures_(std::exchange(other.textures_, {})),
      pages_(std::exchange(other.pages_, {})), refs_(std::exchange(other.refs_, {})),
      pageRefs_(std::exchange(other.pageRefs_, {})), layer_(other.layer_), level_(other.level_),
      row_(other.row_), isBegun_(other.isBegun_), isUnused_(other.isUnused_) {}

TextureStore& TextureStore::operator=(TextureStore&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(staged_, other.staged_);
    std::swap(shared_, other.shared_);
    std::swap(textures_, other.textures_);
    std::swap(pages_, other.pages_);
    std::swap(refs_, other.refs_);
    std::swap(pageRefs_, other.pageRefs_);
    std::swap(layer_, other.layer_);
    std::swap(level_, other.level_);
    std::swap(row_, other.row_);
    std::swap(isBegun_, other.isBegun_);
    std::swap(isUnused_, other.isUnused_);
    return *this;
}

TextureStore::~TextureStore() {
    const bool isSampledByHandle =
        std::any_of(textures_.begin(), textures_.end(), [](const auto& t) { return t->handle() != 0; });
    if (isSampledByHandle && !isUnused_)
        device_->finishFrames();
}

bool TextureStore::releaseSome() {
    constexpr std::size_t kAtOnce = 4;
    LIMEN_ASSERT(isUnused_, "no frame samples them");
    shared_.clear();
    textures_.resize(textures_.size() - std::min(kAtOnce, textures_.size()));
    return !textures_.empty();
}

std::vector<TextureContent> TextureStore::contents() const {
    std::vector<TextureContent> contents;
    for (const auto& texture : textures_)
        contents.push_back(texture->content());
    return contents;
}

Result<void> TextureStore::begin(const StagedTexture& staged) {
    layer_ = level_ = 0;
    row_ = 0;
    isBegun_ = true;
    std::shared_ptr<ResidentTexture>& shared = shared_[textures_.size()];
    if (staged.isShared && shared == nullptr)
        return fail(ErrorCode::BadArgument, staged.label,
                    "is no longer on the device; stage the scene again");
    if (shared != nullptr) {
        textures_.push_back(std::move(shared));
        return {};
    }
    const Result<TextureHandle> made = device_->createTexture(staged.label, staged.content.shape);
    if (!made)
        return Failure(made.error());
    textures_.push_back(std::make_shared<ResidentTexture>(*device_, *made, staged.content));
    return {};
}

bool TextureStore::write(const StagedTexture& staged, std::size_t& bytes) {
    for (; layer_ < staged.layers.size(); ++layer_, level_ = 0) {
        for (; level_ < staged.layers[layer_].size(); ++level_, row_ = 0) {
            const MipLevel& level = staged.layers[layer_][level_];
            const std::size_t rowBytes = std::size_t{level.width} * 4;
            while (row_ < level.height) {
                if (bytes == 0)
                    return false;
                const auto count = static_cast<std::uint32_t>(
                    std::clamp<std::size_t>(bytes / rowBytes, 1, level.height - row_));
                device_->writeTexture(textures_.back()->texture(),
                                      {static_cast<std::uint32_t>(layer_), static_cast<std::uint32_t>(level_),
                                       level.width, row_, count},
                                      std::span(level.rgba).subspan(row_ * rowBytes, count * rowBytes));
                row_ += count;
                bytes -= std::min(bytes, count * rowBytes);
            }
        }
    }
    return true;
}

Result<bool> TextureStore::advance(std::size_t& bytes) {
    constexpr std::size_t kMaking = 4096; // bytes that the creation of a texture counts for
    while (isBegun_ || textures_.size() < staged_.textures.size()) {
        if (bytes == 0)
            return false;
        if (!isBegun_) {
            if (Result<void> begun = begin(staged_.textures[textures_.size()]); !begun)
                return Failure(begun.error());
        }
        StagedTexture& staged = staged_.textures[textures_.size() - 1];
        if (!write(staged, bytes))
            return false;
        bytes -= std::min(bytes, kMaking);
        staged.layers = {};
        isBegun_ = false;
        if (staged_.bindless && textures_.back()->handle() == 0 && !textures_.back()->takeHandle())
            return fail(ErrorCode::Driver, device_->capabilities().renderer,
                        "refused a texture handle; use --textures pages");
    }
    if (refs_.empty())
        writeRefs();
    return true;
}

void TextureStore::writeRefs() {
    for (std::size_t i = 0; i < staged_.locations.size(); ++i) {
        const auto [texture, layer] = staged_.locations[i];
        const std::uint64_t handle = textures_[texture]->handle();
        refs_.push_back(staged_.bindless
                            ? makeRef(static_cast<std::uint32_t>(handle),
                                      static_cast<std::uint32_t>(handle >> 32), staged_.stored[i])
                            : makeRef(layer, texture, staged_.stored[i]));
    }
    if (staged_.hasAtlas())
        pageRefs_ = refs_;
    for (std::size_t i = 0; i < refs_.size() && staged_.hasAtlas(); ++i) {
        if (const std::optional<AtlasEntry>& entry = staged_.inAtlas[i]) {
            const frame::gpu::uvec2 place = atlasPlace(entry->stored, entry->spot);
            refs_[i] = makeRef(place.x, place.y, entry->stored);
        }
    }
    for (std::size_t i = 0; i < textures_.size() && !staged_.bindless; ++i)
        pages_.push_back(textures_[i]->texture());
}

} // namespace limen::gpu
