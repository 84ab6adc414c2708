#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace limen::gpu {

/// How one texture is stored: its size and how it wraps.
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
    std::uint32_t resampled = 0;            ///< textures whose page is larger than they are
};

/// One page per class of textures, in order of first appearance, a class of more than `maxLayers` in several.
/// If that is more than `maxPages`, the two pages (of equal wrapping) whose union adds the fewest texels
/// become one, of the larger width and height, until it fits. Requires maxPages >= 2. Should whole layers not
/// fit, the result has more pages than `maxPages` and the caller says so. Cost: cubic in the number of
/// classes.
/// `before`: shapes of pages that come first, whether they are needed (else they have no layers) or not, if all fit with no two
/// becoming one.
[[nodiscard]] PageLayout layOutPages(std::span<const TextureClass> textures, std::uint32_t maxPages,
                                     std::uint32_t maxLayers, std::span<const TextureClass> before = {});

} // namespace limen::gpu
