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

/// A picture in memory: R, G, B bytes, sRGB, top row first, no padding.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    Picture() = default;
    Picture(std::uint32_t w, std::uint32_t h, Rgb fill = {0, 0, 0});
    [[nodiscard]] Rgb at(std::uint32_t x, std::uint32_t y) const {
        const std::size_t i = (static_cast<std::size_t>(y) * width + x) * 3;
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
    /// Sets a pixel. Coordinates outside of the picture are ignored.
    void set(std::int64_t x, std::int64_t y, Rgb colour);
};

/// Converts R, G, B, A bytes and drops alpha. Requires rgba.size() == width*height*4.
[[nodiscard]] Picture pictureFromRgba(std::uint32_t width, std::uint32_t height,
                                      std::span<const std::uint8_t> rgba);

/// Reduces a picture to fit into a box, with the same proportions. Each pixel is the mean of those it covers.
/// A picture that fits already stays as it is.
[[nodiscard]] Picture shrunkToFit(const Picture& picture, std::uint32_t maxWidth, std::uint32_t maxHeight);

/// Draws a line, two pixels wide, between two points in pixels (x right, y down, corners of pixels at
/// integers).
void drawLine(Picture& picture, double x0, double y0, double x1, double y1, Rgb colour);

/// Draws ASCII text in letters about 7·scale pixels high. (x, y) is its top left corner in pixels.
void drawText(Picture& picture, std::uint32_t x, std::uint32_t y, std::uint32_t scale, std::string_view text,
              Rgb colour);

/// A colour for the n-th item of a list. Neighbours differ clearly; the same n always gives the same colour.
[[nodiscard]] Rgb distinctColour(std::uint32_t n);

/// A sheet of at most `maxCount` pictures, chosen evenly among `frameCount` frames: `columns` columns, each
/// `tileWidth` pixels wide, with labels below the pictures. The caller adds the frames one by one.
class ContactSheet {
public:
    ContactSheet(std::size_t frameCount, std::size_t maxCount, std::uint32_t columns,
                 std::uint32_t tileWidth);
    /// Whether the sheet shows this frame.
    [[nodiscard]] bool wants(std::size_t frame) const;
    void add(const Picture& frame, std::string_view label);
    /// The sheet of the frames added so far; an empty picture without any.
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
