#pragma once

#include "core/Error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace limen::output {

using Rgb = std::array<std::uint8_t, 3>;

/// A picture in memory: R,G,B bytes, sRGB, top row first, no padding.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    Picture() = default;
    Picture(std::uint32_t w, std::uint32_t h, Rgb fill = {0, 0, 0});
    [[nodiscard]] Rgb at(std::uint32_t x, std::uint32_t y) const {
        const std::size_t i = (static_cast<std::size_t>(y) * width + x) * 3;
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
    /// Writes a pixel; outside the picture it does nothing.
    void set(std::int64_t x, std::int64_t y, Rgb colour);
};

/// From R,G,B,A bytes, alpha dropped. Requires rgba.size() == width*height*4.
[[nodiscard]] Picture pictureFromRgba(std::uint32_t width, std::uint32_t height,
                                      std::span<const std::uint8_t> rgba);

/// The picture as PNG, 8 bits RGB. Errors: no pixels; out of memory.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const Picture& picture);
/// R,G,B,A bytes as PNG, with their alpha, not premultiplied. Requires rgba.size() == width*height*4. Errors: likewise.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(std::uint32_t width, std::uint32_t height,
                                                       std::span<const std::uint8_t> rgba);

/// The picture reduced to fit a box, keeping its proportions, each pixel the mean of those it covers; never
/// enlarged.
[[nodiscard]] Picture shrunkToFit(const Picture& picture, std::uint32_t maxWidth, std::uint32_t maxHeight);

/// A line two pixels wide between two points in pixels (x right, y down, corners of pixels at whole numbers).
void drawLine(Picture& picture, double x0, double y0, double x1, double y1, Rgb colour);

/// Text in letters about 7·scale pixels high, its top left corner at (x, y); ASCII only.
void drawText(Picture& picture, std::uint32_t x, std::uint32_t y, std::uint32_t scale, std::string_view text,
              Rgb colour);

/// A colour for the n-th thing of a list: neighbours differ clearly, the same n always gives the same.
[[nodiscard]] Rgb distinctColour(std::uint32_t n);

/// Pictures side by side, evenly picked: at most `maxCount` of them, in `columns` columns, each `tileWidth`
/// wide with its label below. The caller adds frames one by one and says beforehand how many there will be.
class ContactSheet {
public:
    ContactSheet(std::size_t frameCount, std::size_t maxCount, std::uint32_t columns,
                 std::uint32_t tileWidth);
    /// True if the sheet wants this frame.
    [[nodiscard]] bool wants(std::size_t frame) const;
    void add(const Picture& frame, std::string_view label);
    /// The sheet of what was added; without any frame an empty picture.
    [[nodiscard]] Picture compose() const;

private:
    struct Tile {
        Picture picture;
        std::string label;
    };
    std::size_t frameCount_, maxCount_;
    std::uint32_t columns_, tileWidth_;
    std::vector<Tile> tiles_;
};

} // namespace limen::output
