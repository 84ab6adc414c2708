#include "world/texture/Textures.h"

#include "core/Assert.h"
#include "world/texture/Dxt.h"
#include "world/texture/Jpeg.h"

#include <algorithm>
#include <array>
#include <optional>

namespace limen::world {
namespace {

using dat::PixelFormat;
using Texel = std::array<std::uint8_t, 4>;

constexpr std::int32_t kLargestSide = 4096;

std::optional<DxtKind> dxtKind(PixelFormat format) {
    switch (format) {
    case PixelFormat::Dxt1:
        return DxtKind::Dxt1;
    case PixelFormat::Dxt3:
        return DxtKind::Dxt3;
    case PixelFormat::Dxt5:
        return DxtKind::Dxt5;
    default:
        return std::nullopt;
    }
}

/// Bytes of a texel; 0 for formats that are not arrays of texels.
std::size_t texelBytes(PixelFormat format) {
    switch (format) {
    case PixelFormat::A8R8G8B8:
    case PixelFormat::X8R8G8B8:
        return 4;
    case PixelFormat::R8G8B8:
    case PixelFormat::LandscapeR8G8B8:
        return 3;
    case PixelFormat::R5G6B5:
    case PixelFormat::X1R5G5B5:
    case PixelFormat::A1R5G5B5:
    case PixelFormat::A4R4G4B4:
    case PixelFormat::Index16:
        return 2;
    case PixelFormat::A8:
    case PixelFormat::P8:
    case PixelFormat::L8:
    case PixelFormat::LandscapeAlpha:
        return 1;
    default:
        return 0;
    }
}

Texel fromPalette(const dat::Palette& palette, std::size_t index, const DecodeRules& rules) {
    if (rules.clipMap && index < 8)
        return {0, 0, 0, 0};
    const std::uint32_t argb = palette.colours[std::min(index, palette.colours.size() - 1)].argb;
    return {static_cast<std::uint8_t>(argb >> 16), static_cast<std::uint8_t>(argb >> 8),
            static_cast<std::uint8_t>(argb), static_cast<std::uint8_t>(argb >> 24)};
}

Texel fromBytes(PixelFormat format, const std::uint8_t* p, const dat::Palette* palette,
                const DecodeRules& rules) {
    const unsigned both = texelBytes(format) == 2 ? static_cast<unsigned>(p[0] | p[1] << 8) : 0u;
    const auto scaled = [both](unsigned shift, unsigned bits) {
        const unsigned value = both >> shift & ((1u << bits) - 1u);
        return static_cast<std::uint8_t>(value << (8 - bits) | value >> (2 * bits - 8));
    };
    switch (format) {
    case PixelFormat::A8R8G8B8:
        return {p[2], p[1], p[0], p[3]};
    case PixelFormat::R5G6B5:
        return {scaled(11, 5), scaled(5, 6), scaled(0, 5), 255};
    case PixelFormat::X1R5G5B5:
        return {scaled(10, 5), scaled(5, 5), scaled(0, 5), 255};
    case PixelFormat::A1R5G5B5:
        return {scaled(10, 5), scaled(5, 5), scaled(0, 5),
                static_cast<std::uint8_t>(both >> 15 != 0 ? 255 : 0)};
    case PixelFormat::A4R4G4B4:
        return {scaled(8, 4), scaled(4, 4), scaled(0, 4), scaled(12, 4)};
    case PixelFormat::Index16:
        return fromPalette(*palette, both, rules);
    case PixelFormat::P8:
        return fromPalette(*palette, p[0], rules);
    case PixelFormat::A8:
        return rules.additive ? Texel{p[0], p[0], p[0], p[0]} : Texel{255, 255, 255, p[0]};
    case PixelFormat::L8:
        return {p[0], p[0], p[0], 255};
    case PixelFormat::LandscapeAlpha:
        return {p[0], p[0], p[0], p[0]};
    default: // R8G8B8, X8R8G8B8, LandscapeR8G8B8
        return {p[2], p[1], p[0], 255};
    }
}

Result<void> check(const dat::RenderSurface& picture, const dat::Palette* palette) {
    if (picture.width < 1 || picture.height < 1 || picture.width > kLargestSide ||
        picture.height > kLargestSide)
        return fail(ErrorCode::Malformed, "", "the picture's width or height is out of 1..4096");
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    std::size_t needed = width * height * texelBytes(picture.format);
    if (const std::optional<DxtKind> kind = dxtKind(picture.format))
        needed = (width + 3) / 4 * ((height + 3) / 4) * (*kind == DxtKind::Dxt1 ? 8 : 16);
    if (needed == 0)
        return fail(ErrorCode::Unsupported, "", "picture in a format that is not supported");
    if (picture.pixels.size() != needed)
        return fail(ErrorCode::Malformed, "", "picture whose byte count does not fit its size");
    if (isIndexed(picture.format) && (palette == nullptr || palette->colours.empty()))
        return fail(ErrorCode::Malformed, "", "indexed picture without a palette");
    return {};
}

} // namespace

Result<Image> decodeImage(const dat::RenderSurface& picture, const dat::Palette* palette,
                          const DecodeRules& rules) {
    if (picture.format == PixelFormat::RawJpeg) // the file has its own size; the record's may be wrong
        return decodeJpeg(picture.pixels, kLargestSide);
    if (Result<void> fine = check(picture, palette); !fine)
        return Failure(fine.error());
    LIMEN_ASSERT(!isIndexed(picture.format) || !palette->colours.empty(), "check() refuses an empty palette");
    Image image;
    image.width = static_cast<std::uint32_t>(picture.width);
    image.height = static_cast<std::uint32_t>(picture.height);
    image.isIndexed = isIndexed(picture.format);
    image.rgba.resize(std::size_t{image.width} * image.height * 4);
    if (const std::optional<DxtKind> kind = dxtKind(picture.format)) {
        decodeDxt(*kind, image.width, image.height, picture.pixels, image.rgba);
    } else {
        const std::size_t step = texelBytes(picture.format);
        for (std::size_t i = 0; i * step < picture.pixels.size(); ++i) {
            const Texel texel = fromBytes(picture.format, picture.pixels.data() + i * step, palette, rules);
            std::copy(texel.begin(), texel.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i * 4));
        }
    }
    for (std::size_t i = 3; i < image.rgba.size() && !image.hasAlpha; i += 4)
        image.hasAlpha = image.rgba[i] < 255;
    return image;
}

void bleedColour(Image& image) {
    LIMEN_ASSERT(image.rgba.size() == std::size_t{image.width} * image.height * 4, "four bytes a texel");
    const auto width = static_cast<std::int64_t>(image.width),
               height = static_cast<std::int64_t>(image.height);
    const std::vector<std::uint8_t> source = image.rgba;
    for (std::int64_t y = 0; y < height; ++y) {
        for (std::int64_t x = 0; x < width; ++x) {
            const auto at = static_cast<std::size_t>((y * width + x) * 4);
            if (source[at + 3] != 0)
                continue;
            unsigned sum[3] = {0, 0, 0}, count = 0;
            for (std::int64_t ny = std::max<std::int64_t>(y - 1, 0); ny <= std::min(y + 1, height - 1);
                 ++ny) {
                for (std::int64_t nx = std::max<std::int64_t>(x - 1, 0); nx <= std::min(x + 1, width - 1);
                     ++nx) {
                    const auto n = static_cast<std::size_t>((ny * width + nx) * 4);
                    if (source[n + 3] == 0)
                        continue;
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += source[n + c];
                    ++count;
                }
            }
            for (std::size_t c = 0; c < 3 && count > 0; ++c)
                image.rgba[at + c] = static_cast<std::uint8_t>(sum[c] / count);
        }
    }
}

} // namespace limen::world
