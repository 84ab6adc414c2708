#include "gpu/texture/MipChain.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace limen::gpu {
namespace {

// Sums over the texels that one texel of the next level covers.
struct Sums {
    std::array<std::uint32_t, 3> weighted{}, plain{};
    std::uint32_t alpha = 0, count = 0;

    void add(const std::uint8_t* texel) {
        for (std::size_t c = 0; c < 3; ++c) {
            weighted[c] += std::uint32_t{texel[c]} * texel[3];
            plain[c] += texel[c];
        }
        alpha += texel[3];
        ++count;
    }
    void write(std::uint8_t* texel) const {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t mean =
                alpha > 0 ? (weighted[c] + alpha / 2) / alpha : (plain[c] + count / 2) / count;
            texel[c] = static_cast<std::uint8_t>(mean);
        }
        texel[3] = static_cast<std::uint8_t>((alpha + count / 2) / count);
    }
};

struct Range {
    std::uint32_t first = 0, end = 0;
};

// Texels of a side of `size` covered by texel `i` of the halved side. The last one also covers an odd texel.
Range covered(std::uint32_t i, std::uint32_t size, std::uint32_t halved) {
    const std::uint32_t first = std::min(2 * i, size - 1);
    return {first, i + 1 == halved ? size : first + 2};
}

MipLevel nextLevel(const MipLevel& from) {
    MipLevel to{std::max(1u, from.width / 2), std::max(1u, from.height / 2), {}};
    to.rgba.resize(std::size_t{to.width} * to.height * 4);
    for (std::uint32_t y = 0; y < to.height; ++y) {
        const Range rows = covered(y, from.height, to.height);
        for (std::uint32_t x = 0; x < to.width; ++x) {
            const Range columns = covered(x, from.width, to.width);
            Sums sums;
            for (std::uint32_t row = rows.first; row < rows.end; ++row)
                for (std::uint32_t column = columns.first; column < columns.end; ++column)
                    sums.add(&from.rgba[(std::size_t{row} * from.width + column) * 4]);
            sums.write(&to.rgba[(std::size_t{y} * to.width + x) * 4]);
        }
    }
    return to;
}

/// Two texels along a side, and the share of the second.
struct Between {
    std::size_t first = 0, second = 0;
    double share = 0.0;
};

/// Around the middle of texel `at` of a side of `newSize`, of a picture that repeats.
Between between(std::uint32_t at, std::uint32_t newSize, std::uint32_t size) {
    const double middle = (at + 0.5) * size / newSize + 0.5; // from the texel before the first
    const auto next = static_cast<std::size_t>(middle);
    return {(next + size - 1) % size, next % size, middle - std::floor(middle)};
}

} // namespace

std::uint32_t mipLevelCount(std::uint32_t width, std::uint32_t height) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(width, height)));
}

std::vector<MipLevel> mipChain(std::uint32_t width, std::uint32_t height,
                               std::span<const std::uint8_t> rgba) {
    LIMEN_ASSERT(width >= 1 && height >= 1 && rgba.size() == std::size_t{width} * height * 4,
                 "four bytes per texel");
    std::vector<MipLevel> levels;
    levels.reserve(mipLevelCount(width, height));
    levels.push_back({width, height, {rgba.begin(), rgba.end()}});
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(nextLevel(levels.back()));
    return levels;
}

MipLevel enlarged(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba,
                  std::uint32_t newWidth, std::uint32_t newHeight) {
    LIMEN_ASSERT(newWidth >= width && newHeight >= height && width >= 1 && height >= 1,
                 "the new size is not smaller");
    MipLevel out{newWidth, newHeight, {}};
    out.rgba.resize(std::size_t{newWidth} * newHeight * 4);
    for (std::uint32_t y = 0; y < newHeight; ++y) {
        const std::uint64_t row = std::uint64_t{y} * height / newHeight;
        for (std::uint32_t x = 0; x < newWidth; ++x) {
            const std::uint64_t column = std::uint64_t{x} * width / newWidth;
            std::memcpy(&out.rgba[(std::size_t{y} * newWidth + x) * 4], &rgba[(row * width + column) * 4], 4);
        }
    }
    return out;
}

MipLevel resized(std::span<const MipLevel> levels, std::uint32_t width, std::uint32_t height) {
    LIMEN_ASSERT(!levels.empty() && width >= 1 && height >= 1, "a picture");
    const auto isSmaller = [&](const MipLevel& level) {
        return level.width < width || level.height < height;
    };
    const auto smaller = std::find_if(levels.begin(), levels.end(), isSmaller);
    const MipLevel& from = smaller == levels.begin() ? levels.front() : *(smaller - 1);
    MipLevel out{width, height, {}};
    out.rgba.reserve(std::size_t{width} * height * 4);
    for (std::uint32_t y = 0; y < height; ++y) {
        const Between rows = between(y, height, from.height);
        for (std::uint32_t x = 0; x < width; ++x) {
            const Between columns = between(x, width, from.width);
            for (std::size_t c = 0; c < 4; ++c) {
                const auto inRow = [&](std::size_t row) {
                    const std::uint8_t* texels = &from.rgba[row * from.width * 4 + c];
                    return std::lerp(double{1} * texels[columns.first * 4],
                                     double{1} * texels[columns.second * 4], columns.share);
                };
                out.rgba.push_back(static_cast<std::uint8_t>(
                    std::lround(std::lerp(inRow(rows.first), inRow(rows.second), rows.share))));
            }
        }
    }
    return out;
}

} // namespace limen::gpu
