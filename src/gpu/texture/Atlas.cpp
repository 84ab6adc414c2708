#include "gpu/texture/Atlas.h"

#include "core/Assert.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

/// Texels of a layer. Textures of up to 512 texels a side fit. Programs have the size as a constant, so they seldom depend on the
/// textures. Four textures of 128 texels fill a shelf. The next texel of a column is in other sets of a processor's cache,
/// because the width is an odd number of cache lines.
constexpr std::uint32_t kUsualWidth = 784, kUsualHeight = 2048;
constexpr std::uint32_t kCacheLine = 16; // texels
constexpr std::uint32_t kMostLayers = 256;
constexpr std::uint32_t kBorder = 1;

/// Corner of a level's border from that of level 0. Level 0 is on the left, the others are below each other beside it. Of the three
/// rows between them two are borders. The third is for levels of one row, whose height has no further half.
AtlasSpot levelCorner(std::uint32_t width, std::uint32_t height, std::uint32_t level) {
    if (level == 0)
        return {};
    return {0, width + 2 * kBorder, height - (height >> (level - 1)) + 3 * (level - 1)};
}

struct Extent {
    std::uint32_t width = 0, height = 0;
};

Extent extentOf(const TextureClass& texture) {
    const std::uint32_t last = mipLevelCount(texture.width, texture.height) - 1;
    const AtlasSpot corner = levelCorner(texture.width, texture.height, last);
    const std::uint32_t beside = last == 0 ? 0 : std::max(texture.width / 2, 1u) + 2 * kBorder;
    return {texture.width + 2 * kBorder + beside,
            std::max(texture.height + 2 * kBorder, corner.y + 1 + 2 * kBorder)};
}

/// Shelves from the top of each layer down, each as high as its first texture.
class Shelves {
public:
    /// `used`: rows of the first layer.
    Shelves(const Extent& layer, std::uint32_t used) : layer_(layer), y_(used) {}
    /// Requires textures in order of falling height.
    AtlasSpot add(const Extent& extent) {
        if (x_ + extent.width > layer_.width) {
            y_ += height_;
            x_ = height_ = 0;
        }
        if (y_ + std::max(height_, extent.height) > layer_.height) {
            ++number_;
            x_ = y_ = height_ = 0;
        }
        const AtlasSpot spot{number_, x_, y_};
        height_ = std::max(height_, extent.height);
        x_ += extent.width;
        return spot;
    }
    [[nodiscard]] std::uint32_t layers() const { return number_ + 1; }

private:
    Extent layer_;
    std::uint32_t number_ = 0, x_ = 0, y_ = 0, height_ = 0;
};

AtlasLayout layOutWith(const Extent& size, bool hasGrains, std::span<const Extent> extents,
                       std::span<const std::uint32_t> order) {
    AtlasLayout layout{size.width, size.height, 0, std::vector<AtlasSpot>(extents.size())};
    Shelves shelves(size, hasGrains ? 2 * kGrainRows : 0);
    for (const std::uint32_t texture : order)
        layout.spots[texture] = shelves.add(extents[texture]);
    layout.layers = shelves.layers();
    return layout;
}

/// The texel of a side of `size` that a texel of the border or of the level repeats. `at`: from the border on.
std::uint32_t repeated(std::uint32_t at, std::uint32_t size, bool clamp) {
    if (clamp)
        return std::clamp(at, kBorder, size) - kBorder;
    return (at + size - kBorder) % size;
}

} // namespace

std::optional<AtlasLayout> layOutAtlas(std::span<const TextureClass> textures, bool hasGrains,
                                       std::uint32_t maxSide, std::uint32_t maxLayers) {
    std::vector<Extent> extents;
    Extent size{kUsualWidth, kUsualHeight};
    for (const TextureClass& texture : textures) {
        extents.push_back(extentOf(texture));
        size = {std::max(size.width, extents.back().width), std::max(size.height, extents.back().height)};
    }
    size = {((size.width + kCacheLine - 1) / kCacheLine | 1u) * kCacheLine, std::bit_ceil(size.height)};
    if ((textures.empty() && !hasGrains) ||
        std::max(size.width, size.height) > std::min(maxSide, 1u << kAtlasY))
        return std::nullopt;
    std::vector<std::uint32_t> order(textures.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return extents[a].height != extents[b].height ? extents[a].height > extents[b].height
                                                      : extents[a].width > extents[b].width;
    });
    AtlasLayout found = layOutWith(size, hasGrains, extents, order);
    return found.layers <= std::min(maxLayers, kMostLayers) ? std::optional(std::move(found)) : std::nullopt;
}

std::array<AtlasSpot, 2> grainSpots() {
    LIMEN_ASSERT(extentOf({kGrainSide, kGrainSide, false}).height == kGrainRows &&
                     mipLevelCount(kGrainSide, kGrainSide) == kGrainLevels &&
                     kNoGrainRow >= kGrainSide + 2 * kBorder && kNoGrainRow < kGrainRows,
                 "the shader knows the grains' places");
    return {AtlasSpot{}, AtlasSpot{0, 0, kGrainRows}};
}

layout::uvec2 atlasPlace(const TextureClass& texture, const AtlasSpot& spot) {
    const std::uint32_t last = mipLevelCount(texture.width, texture.height) - 1;
    return {spot.x | spot.y << kAtlasY | spot.layer << kAtlasLayer,
            texture.width | texture.height << kAtlasHeight | last << kAtlasLastLevel |
                (texture.clamp ? kAtlasClamp : 0u)};
}

void putIntoAtlas(std::span<const MipLevel> levels, bool clamp, const AtlasSpot& spot, MipLevel& layer) {
    for (std::uint32_t i = 0; i < levels.size(); ++i) {
        const MipLevel& level = levels[i];
        const AtlasSpot corner = levelCorner(levels[0].width, levels[0].height, i);
        LIMEN_ASSERT(spot.x + corner.x + level.width + 2 * kBorder <= layer.width &&
                         spot.y + corner.y + level.height + 2 * kBorder <= layer.height,
                     "the level is within the layer");
        for (std::uint32_t y = 0; y < level.height + 2 * kBorder; ++y) {
            const std::size_t from = std::size_t{repeated(y, level.height, clamp)} * level.width;
            const std::size_t row = std::size_t{spot.y + corner.y + y} * layer.width + spot.x + corner.x;
            for (std::uint32_t x = 0; x < level.width + 2 * kBorder; ++x)
                std::memcpy(&layer.rgba[(row + x) * 4],
                            &level.rgba[(from + repeated(x, level.width, clamp)) * 4], 4);
        }
    }
}

} // namespace limen::gpu
