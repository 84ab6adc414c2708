#include "worlds/records/PixelEncoder.h"

#include "core/Assert.h"

#include <array>
#include <limits>
#include <numeric>

namespace limen::worlds {

namespace {

using Rgb = std::array<int, 3>;

int toByte(float value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}
Rgb rgbOf(const Vec4f& c) {
    return {toByte(c.x), toByte(c.y), toByte(c.z)};
}

std::uint16_t to565(const Rgb& c) {
    return static_cast<std::uint16_t>(((c[0] * 31 + 127) / 255) << 11 | ((c[1] * 63 + 127) / 255) << 5 |
                                      ((c[2] * 31 + 127) / 255));
}
Rgb from565(std::uint16_t v) {
    const int r = v >> 11;
    const int g = (v >> 5) & 63;
    const int b = v & 31;
    return {(r * 255 + 15) / 31, (g * 255 + 31) / 63, (b * 255 + 15) / 31};
}

int distanceSquared(const Rgb& a, const Rgb& b) {
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]);
}

class ByteSink {
public:
    explicit ByteSink(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
    void u8(int v) { bytes_.push_back(static_cast<std::uint8_t>(v)); }
    void u16(unsigned v) {
        u8(static_cast<int>(v & 0xFF));
        u8(static_cast<int>((v >> 8) & 0xFF));
    }
    void u32(std::uint32_t v) {
        u16(v & 0xFFFF);
        u16(v >> 16);
    }

private:
    std::vector<std::uint8_t>& bytes_;
};

/// Median cut: boxes of texels split along their longest side until there are enough.
/// ref: P. Heckbert, Color Image Quantization for Frame Buffer Display, 1982.
struct ColourBox {
    std::size_t begin = 0, end = 0;
    int axis = 0, extent = 0;
};

ColourBox measure(const std::vector<Rgb>& colours, std::size_t begin, std::size_t end) {
    ColourBox box{begin, end, 0, -1};
    for (int axis = 0; axis < 3; ++axis) {
        int low = 255;
        int high = 0;
        for (std::size_t i = begin; i < end; ++i) {
            low = std::min(low, colours[i][static_cast<std::size_t>(axis)]);
            high = std::max(high, colours[i][static_cast<std::size_t>(axis)]);
        }
        if (high - low > box.extent) {
            box.extent = high - low;
            box.axis = axis;
        }
    }
    return box;
}

std::vector<Rgb> medianCut(std::vector<Rgb> colours, std::size_t count) {
    std::vector<ColourBox> boxes{measure(colours, 0, colours.size())};
    while (boxes.size() < count) {
        const auto widest = std::max_element(
            boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.extent < b.extent; });
        if (widest->extent <= 0 || widest->end - widest->begin < 2)
            break;
        const ColourBox box = *widest;
        const std::size_t middle = (box.begin + box.end) / 2;
        const auto axis = static_cast<std::size_t>(box.axis);
        std::sort(colours.begin() + static_cast<std::ptrdiff_t>(box.begin),
                  colours.begin() + static_cast<std::ptrdiff_t>(box.end), [axis](const Rgb& a, const Rgb& b) {
                      return a[axis] != b[axis] ? a[axis] < b[axis] : a < b;
                  });
        *widest = measure(colours, box.begin, middle);
        boxes.push_back(measure(colours, middle, box.end));
    }
    std::vector<Rgb> palette;
    for (const ColourBox& box : boxes) {
        std::array<long, 3> sum{};
        for (std::size_t i = box.begin; i < box.end; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += colours[i][k];
        const long n = std::max<long>(1, static_cast<long>(box.end - box.begin));
        palette.push_back(
            {static_cast<int>(sum[0] / n), static_cast<int>(sum[1] / n), static_cast<int>(sum[2] / n)});
    }
    return palette;
}

/// Indices below this are transparent on clip maps, so no opaque texel may use them.
constexpr std::size_t kReservedIndices = 8;

void encodePalettised(const Canvas& canvas, bool wide, EncodedImage& out) {
    const std::size_t size = wide ? 2048 : 256;
    std::vector<Rgb> opaque;
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x)
            if (canvas.at(x, y).w >= 0.5f)
                opaque.push_back(rgbOf(canvas.at(x, y)));
    }
    if (opaque.empty())
        opaque.push_back({0, 0, 0});
    const std::vector<Rgb> colours = medianCut(opaque, size - kReservedIndices);
    out.palette.colours.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
        const Rgb c =
            i < kReservedIndices ? Rgb{0, 0, 0} : colours[std::min(i - kReservedIndices, colours.size() - 1)];
        out.palette.colours[i].argb = 0xFF000000u | static_cast<std::uint32_t>(c[0] << 16 | c[1] << 8 | c[2]);
    }
    // The nearest entry, cached by 15-bit colour. A full search for every texel would take seconds.
    std::vector<int> nearest(1u << 15, -1);
    ByteSink writer(out.image.pixels);
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            std::size_t index = 0;
            if (canvas.at(x, y).w >= 0.5f) {
                const Rgb c = rgbOf(canvas.at(x, y));
                int& known =
                    nearest[static_cast<std::size_t>((c[0] >> 3) << 10 | (c[1] >> 3) << 5 | c[2] >> 3)];
                if (known < 0) {
                    const auto best =
                        std::min_element(colours.begin(), colours.end(), [&c](const Rgb& a, const Rgb& b) {
                            return distanceSquared(a, c) < distanceSquared(b, c);
                        });
                    known = static_cast<int>(best - colours.begin());
                }
                index = static_cast<std::size_t>(known) + kReservedIndices;
            }
            wide ? writer.u16(static_cast<unsigned>(index)) : writer.u8(static_cast<int>(index));
        }
    }
}

struct Block {
    std::array<Rgb, 16> texels;
    std::array<bool, 16> clear{};
    bool anyClear = false;
};

Block gatherBlock(const Canvas& canvas, int bx, int by) {
    Block block;
    for (int i = 0; i < 16; ++i) {
        const Vec4f& c = canvas.at(bx + i % 4, by + i / 4);
        const auto k = static_cast<std::size_t>(i);
        block.texels[k] = rgbOf(c);
        block.clear[k] = c.w < 0.5f;
        block.anyClear = block.anyClear || block.clear[k];
    }
    return block;
}

/// The two texels farthest apart along the block's colour diagonal, moved a little towards each other.
std::pair<Rgb, Rgb> endPoints(const Block& block) {
    int best = -1;
    std::pair<Rgb, Rgb> out{block.texels[0], block.texels[0]};
    for (std::size_t a = 0; a < 16; ++a) {
        for (std::size_t b = a; b < 16; ++b) {
            const int d =
                block.clear[a] || block.clear[b] ? -1 : distanceSquared(block.texels[a], block.texels[b]);
            if (d > best) {
                best = d;
                out = {block.texels[a], block.texels[b]};
            }
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const int inset = (out.second[k] - out.first[k]) / 16;
        out.first[k] += inset;
        out.second[k] -= inset;
    }
    return out;
}

void encodeDxt1Block(const Block& block, ByteSink& writer) {
    const auto [first, second] = endPoints(block);
    std::uint16_t c0 = to565(first);
    std::uint16_t c1 = to565(second);
    // c0 > c1: four colours. c0 <= c1: three colours and transparent.
    if ((c0 < c1) != block.anyClear)
        std::swap(c0, c1);
    const bool three = c0 <= c1;
    const Rgb a = from565(c0);
    const Rgb b = from565(c1);
    std::array<Rgb, 4> palette{a, b, a, b};
    for (std::size_t k = 0; k < 3; ++k) {
        palette[2][k] = three ? (a[k] + b[k]) / 2 : (2 * a[k] + b[k]) / 3;
        palette[3][k] = three ? 0 : (a[k] + 2 * b[k]) / 3;
    }
    std::uint32_t indices = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < (three ? 3u : 4u); ++k)
            if (distanceSquared(palette[k], block.texels[i]) <
                distanceSquared(palette[best], block.texels[i]))
                best = k;
        indices |= (block.clear[i] ? 3u : best) << (2 * i);
    }
    writer.u16(c0);
    writer.u16(c1);
    writer.u32(indices);
}

void encodeDxt1(const Canvas& canvas, std::vector<std::uint8_t>& bytes) {
    ByteSink writer(bytes);
    for (int y = 0; y < canvas.height(); y += 4)
        for (int x = 0; x < canvas.width(); x += 4)
            encodeDxt1Block(gatherBlock(canvas, x, y), writer);
}

void encodeTexel(const Vec4f& texel, dat::PixelFormat format, ByteSink& writer) {
    const Rgb c = rgbOf(texel);
    const int alpha = toByte(texel.w);
    switch (format) {
    case dat::PixelFormat::A8:
    case dat::PixelFormat::LandscapeAlpha:
        writer.u8(alpha);
        break;
    case dat::PixelFormat::R5G6B5:
        writer.u16(to565(c));
        break;
    case dat::PixelFormat::A4R4G4B4:
        writer.u16(static_cast<unsigned>((alpha + 8) / 17 << 12 | (c[0] + 8) / 17 << 8 |
                                         (c[1] + 8) / 17 << 4 | (c[2] + 8) / 17));
        break;
    default:
        writer.u8(c[2]);
        writer.u8(c[1]);
        writer.u8(c[0]);
        if (format == dat::PixelFormat::A8R8G8B8)
            writer.u8(alpha);
    }
}

} // namespace

EncodedImage encodeImage(const Canvas& canvas, dat::PixelFormat format) {
    EncodedImage out;
    out.image.width = canvas.width();
    out.image.height = canvas.height();
    out.image.format = format;
    if (format == dat::PixelFormat::P8 || format == dat::PixelFormat::Index16) {
        encodePalettised(canvas, format == dat::PixelFormat::Index16, out);
    } else if (format == dat::PixelFormat::Dxt1) {
        LIMEN_ASSERT(canvas.width() % 4 == 0 && canvas.height() % 4 == 0, "DXT1 needs whole blocks");
        encodeDxt1(canvas, out.image.pixels);
    } else {
        ByteSink writer(out.image.pixels);
        for (int y = 0; y < canvas.height(); ++y)
            for (int x = 0; x < canvas.width(); ++x)
                encodeTexel(canvas.at(x, y), format, writer);
    }
    return out;
}

} // namespace limen::worlds
