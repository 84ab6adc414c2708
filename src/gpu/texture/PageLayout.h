#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace limen::gpu {

/// Size and wrapping of a stored texture.
struct TextureClass {
    std::uint32_t width = 0, height = 0;
    bool clamp = false;
    bool operator==(const TextureClass&) const = default;
};

/// The layer that holds a texture.
struct TextureLocation {
    std::uint32_t page = 0, layer = 0;
};

/// Array pages for a set of textures.
struct PageLayout {
    struct Page {
        TextureClass shape;
        std::uint32_t layers = 0;
    };
    std::vector<Page> pages;
    std::vector<TextureLocation> locations; ///< one per texture, in order
    std::uint32_t resampled = 0;            ///< textures stored in a page of a larger size
};

/// One page per class of textures, in order of first appearance; several for a class of more than
/// `maxLayers`. While there are more than `maxPages`, the two pages of equal wrapping whose union adds the
/// fewest texels are merged into one of the larger width and height. If layers do not fit, the result has
/// more than `maxPages` pages, which the caller reports. `before`: shapes of existing pages. They keep their
/// numbers, unused ones without layers, if all fit without merging.
/// Requires: maxPages >= 2. Cost: cubic in the number of classes.
[[nodiscard]] PageLayout layOutPages(std::span<const TextureClass> textures, std::uint32_t maxPages,
                                     std::uint32_t maxLayers, std::span<const TextureClass> before = {});

} // namespace limen::gpu
