#include "output/Picture.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wcast-qual"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace limen::output {

Picture::Picture(std::uint32_t w, std::uint32_t h, Rgb fill)
    : width(w), height(h), rgb(static_cast<std::size_t>(w) * h * 3) {
    for (std::size_t i = 0; i < rgb.size(); ++i)
        rgb[i] = fill[i % 3];
}

void Picture::set(std::int64_t x, std::int64_t y, Rgb colour) {
    if (x < 0 || y < 0 || x >= width || y >= height)
        return;
    const std::size_t i = (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * 3;
    std::copy(colour.begin(), colour.end(), rgb.begin() + static_cast<std::ptrdiff_t>(i));
}

Picture pictureFromRgba(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba) {
    LIMEN_ASSERT(rgba.size() == static_cast<std::size_t>(width) * height * 4, "four bytes a pixel");
    Picture picture(width, height);
    for (std::size_t pixel = 0; pixel < rgba.size() / 4; ++pixel)
        std::copy_n(&rgba[pixel * 4], 3, &picture.rgb[pixel * 3]);
    return picture;
}

Picture shrunkToFit(const Picture& picture, std::uint32_t maxWidth, std::uint32_t maxHeight) {
    const double scale = std::min({1.0, static_cast<double>(maxWidth) / picture.width,
                                   static_cast<double>(maxHeight) / picture.height});
    const auto reduced = [scale](std::uint32_t side) {
        return std::max(1u, static_cast<std::uint32_t>(std::lround(side * scale)));
    };
    Picture out(reduced(picture.width), reduced(picture.height));
    for (std::uint32_t y = 0; y < out.height; ++y) {
        const auto y0 = static_cast<std::uint32_t>(std::uint64_t{y} * picture.height / out.height);
        const auto y1 =
            std::max(y0 + 1, static_cast<std::uint32_t>(std::uint64_t{y + 1} * picture.height / out.height));
        for (std::uint32_t x = 0; x < out.width; ++x) {
            const auto x0 = static_cast<std::uint32_t>(std::uint64_t{x} * picture.width / out.width);
            const auto x1 = std::max(
                x0 + 1, static_cast<std::uint32_t>(std::uint64_t{x + 1} * picture.width / out.width));
            std::array<std::uint64_t, 3> sum{};
            for (std::uint32_t sy = y0; sy < y1; ++sy)
                for (std::uint32_t sx = x0; sx < x1; ++sx)
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += picture.at(sx, sy)[c];
            const std::uint64_t count = std::uint64_t{x1 - x0} * (y1 - y0);
            const auto mean = [&](std::size_t c) {
                return static_cast<std::uint8_t>((sum[c] + count / 2) / count);
            };
            out.set(x, y, {mean(0), mean(1), mean(2)});
        }
    }
    return out;
}

void drawLine(Picture& picture, double x0, double y0, double x1, double y1, Rgb colour) {
    const double length = std::max(std::abs(x1 - x0), std::abs(y1 - y0));
    if (!std::isfinite(length))
        return;
    // Bounds the loop: pixels beyond a million steps are outside of any picture.
    const auto steps = static_cast<std::int64_t>(std::min(std::ceil(length), 1e6));
    for (std::int64_t i = 0; i <= steps; ++i) {
        const double t = steps == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(steps);
        const double x = std::clamp(x0 + (x1 - x0) * t, -1e9, 1e9),
                     y = std::clamp(y0 + (y1 - y0) * t, -1e9, 1e9);
        const auto px = static_cast<std::int64_t>(std::floor(x - 0.5)),
                   py = static_cast<std::int64_t>(std::floor(y - 0.5));
        for (std::int64_t dy = 0; dy < 2; ++dy)
            for (std::int64_t dx = 0; dx < 2; ++dx)
                picture.set(px + dx, py + dy, colour);
    }
}

void drawText(Picture& picture, std::uint32_t x, std::uint32_t y, std::uint32_t scale, std::string_view text,
              Rgb colour) {
    struct Corner {
        float x, y, z;
        std::uint8_t rgba[4];
    };
    static_assert(sizeof(Corner) == 16); // stb_easy_font's vertex
    std::string line(text.substr(0, 200));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; },
        '?');                                          // the font has printable ASCII only
    std::vector<Corner> corners(line.size() * 80 + 4); // stb at most 270 bytes a letter
    const int quads = stb_easy_font_print(0.0f, 0.0f, line.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(Corner)));
    for (int q = 0; q < quads; ++q) {
        const Corner& low = corners[static_cast<std::size_t>(q) * 4];
        const Corner& high = corners[static_cast<std::size_t>(q) * 4 + 2];
        const auto pixel = [scale](float v) {
            return static_cast<std::int64_t>(std::lround(v * static_cast<float>(scale)));
        };
        for (std::int64_t py = pixel(low.y); py < pixel(high.y); ++py)
            for (std::int64_t px = pixel(low.x); px < pixel(high.x); ++px)
                picture.set(px + x, py + y, colour);
    }
}

Rgb distinctColour(std::uint32_t n) {
    // Hues a golden section apart (Knuth, The Art of Computer Programming 3, section 6.4, multiplicative
    // hashing).
    const double hue = std::fmod(n * 0.6180339887498949 + 0.08, 1.0) * 6.0;
    const double value = n % 3 == 2 ? 170.0 : 255.0;
    const auto channel = [&](double shift) {
        const double k = std::fmod(hue + shift, 6.0);
        const double share = std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
        return static_cast<std::uint8_t>(std::lround(value * (1.0 - 0.85 * share)));
    };
    return {channel(5.0), channel(3.0), channel(1.0)};
}

ContactSheet::ContactSheet(std::size_t frameCount, std::size_t maxCount, std::uint32_t columns,
                           std::uint32_t tileWidth)
    : frameCount_(frameCount), maxCount_(std::min(frameCount, maxCount)), columns_(columns),
      tileWidth_(tileWidth) {
    LIMEN_ASSERT(columns > 0 && tileWidth > 0, "a sheet has columns with a width");
}

bool ContactSheet::wants(std::size_t frame) const {
    if (frame >= frameCount_)
        return false;
    if (maxCount_ == frameCount_ || maxCount_ <= 1)
        return frame < maxCount_;
    // Tile k shows frame round(k * (frames - 1) / (tiles - 1)), so the first and the last frame are always
    // shown.
    const std::size_t gaps = maxCount_ - 1, last = frameCount_ - 1;
    const std::size_t tile = (frame * gaps + last / 2) / last;
    return (tile * last + gaps / 2) / gaps == frame;
}

void ContactSheet::add(const Picture& frame, std::string_view label) {
    tiles_.push_back({shrunkToFit(frame, tileWidth_, tileWidth_ * 4), std::string(label)});
}

Picture ContactSheet::compose() const {
    if (tiles_.empty())
        return {};
    constexpr std::uint32_t kTileGap = 6, kLabel = 14;
    std::uint32_t tileHeight = 0;
    for (const Tile& tile : tiles_)
        tileHeight = std::max(tileHeight, tile.picture.height);
    const auto count = static_cast<std::uint32_t>(tiles_.size());
    const std::uint32_t columns = std::min(columns_, count), rows = (count + columns - 1) / columns;
    Picture sheet(kTileGap + columns * (tileWidth_ + kTileGap),
                  kTileGap + rows * (tileHeight + kLabel + kTileGap), {24, 24, 28});
    for (std::uint32_t i = 0; i < count; ++i) {
        const Tile& tile = tiles_[i];
        const std::uint32_t left = kTileGap + i % columns * (tileWidth_ + kTileGap),
                            top = kTileGap + i / columns * (tileHeight + kLabel + kTileGap);
        for (std::uint32_t y = 0; y < tile.picture.height; ++y)
            for (std::uint32_t x = 0; x < tile.picture.width; ++x)
                sheet.set(left + x, top + y, tile.picture.at(x, y));
        drawText(sheet, left, top + tileHeight + 4, 1, tile.label, {220, 220, 220});
    }
    return sheet;
}

} // namespace limen::output
