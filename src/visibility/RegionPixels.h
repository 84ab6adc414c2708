#pragma once

#include "visibility/VisibleSet.h"

#include <cstdint>
#include <span>
#include <vector>

// Regions as pixels, for a screen of width × height pixels. Column 0 is on the left, row 0 at the bottom, as in
// OpenGL; a pixel is where its centre is.
namespace limen::visibility {

/// The pixels `firstX`, ..., `lastX` of a row; both included.
struct PixelRun {
    std::uint32_t y = 0, firstX = 0, lastX = 0;
    friend bool operator==(const PixelRun&, const PixelRun&) = default;
};

/// A rectangle of pixels, as glScissor takes it. width or height 0: empty.
struct PixelRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// The pixels whose centres are in the region, edges included: one run a row, from below. `region`: as in VisibleSet.
/// `out` is overwritten. Cost: rows times corners. Empty for fewer than three corners or a screen without pixels.
LIMEN_API void pixelsOf(std::span<const Vec3> region, std::uint32_t width, std::uint32_t height,
                        std::vector<PixelRun>& out);

/// The visit of each pixel: the last one in drawing order whose region has the pixel's centre. `out` is overwritten
/// with width × height indices into `set.visits`, rows from below; kNone where no region is.
LIMEN_API void visitOfPixels(const VisibleSet& set, std::uint32_t width, std::uint32_t height,
                             std::vector<std::uint32_t>& out);

/// The smallest rectangle with all pixels that the region touches, also in part, so that multisampled edges are kept.
/// Cost: corners.
[[nodiscard]] LIMEN_API PixelRect scissorOf(std::span<const Vec3> region, std::uint32_t width,
                                            std::uint32_t height);

/// The same for a rectangle in NDC, e.g. that of a SeenSpace.
[[nodiscard]] LIMEN_API PixelRect scissorOf(const Rect& rect, std::uint32_t width, std::uint32_t height);

} // namespace limen::visibility
