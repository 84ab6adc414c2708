#include "engine/picture/LargePicture.h"

#include "core/Assert.h"
#include "engine/picture/LinearFilter.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::engine {
namespace {

constexpr std::uint64_t kTargetBytes = 16; ///< a sample: colour, depth, ownership, id
constexpr std::uint64_t kReadBytes = 4;    ///< a sample that was read back

/// Whole pixels a tile, an even number of samples, and no more than the picture needs.
std::uint32_t tileSideOf(const LargePictureOptions& options, std::uint32_t picture) {
    const std::uint32_t step = 2 * options.supersample;
    const std::uint32_t needed = (picture * options.supersample + step - 1) / step * step;
    return std::min(std::max(options.tileSide / step, 1u) * step, needed);
}

} // namespace

Result<void> checkLargePicture(PixelSize size, std::uint32_t supersample, std::uint32_t maxViewport) {
    LIMEN_ASSERT(supersample >= 1 && supersample <= kMostSupersampling, "a number of samples a side");
    const std::uint32_t most = std::min(kMaxSide, maxViewport), side = std::max(size.width, size.height);
    if (side > 0 && std::uint64_t{side} * supersample <= most)
        return {};
    const std::uint32_t fitting = side > 0 ? most / side : 0;
    return fail(ErrorCode::BadArgument, fmt::format("a picture of {}x{}", size.width, size.height),
                fmt::format("with {0}x{0} samples a pixel has {1} samples a side, of {2} at most; {3}",
                            supersample, std::uint64_t{side} * supersample, most,
                            fitting > 1    ? fmt::format("use supersampling of {}", fitting)
                            : fitting == 1 ? std::string("leave out supersampling")
                                           : std::string("choose a smaller size")));
}

std::uint64_t bytesOfLargePicture(PixelSize size, const LargePictureOptions& options, std::uint32_t samples) {
    const std::uint64_t picture = std::uint64_t{size.width} * size.height * 3;
    const std::uint64_t tile =
        std::uint64_t{tileSideOf(options, size.width)} * tileSideOf(options, size.height);
    return picture + tile * (kTargetBytes * std::max(samples, 1u) + kReadBytes);
}

LargePicture::LargePicture(gpu::RenderTarget target, FrameRequest request, PixelSize size,
                           std::uint32_t supersample)
    : target_(std::move(target)), request_(std::move(request)), size_(size), supersample_(supersample),
      columns_((request_.size.width + target_.width() - 1) / target_.width()),
      tiles_(std::size_t{columns_} * ((request_.size.height + target_.height() - 1) / target_.height())),
      rgb_(std::size_t{size.width} * size.height * 3) {}

Result<LargePicture> LargePicture::begin(Session& session, FrameRequest request,
                                         const LargePictureOptions& options) {
    const PixelSize size = request.size;
    if (Result<void> fits = checkLargePicture(size, options.supersample, session.capabilities().maxViewport);
        !fits)
        return Failure(fits.error());
    request.size = {size.width * options.supersample, size.height * options.supersample};
    Result<gpu::RenderTarget> target =
        session.makeTile(tileSideOf(options, size.width), tileSideOf(options, size.height));
    if (!target)
        return Failure(target.error());
    return LargePicture(std::move(*target), std::move(request), size, options.supersample);
}

Result<void> LargePicture::drawNext(Session& session) {
    LIMEN_ASSERT(!isDone(), "there is a tile to draw");
    const auto tile = static_cast<std::uint32_t>(drawn_);
    const std::uint32_t left = tile % columns_ * target_.width(), bottom = tile / columns_ * target_.height();
    target_.setTile({left, bottom, request_.size.width, request_.size.height});
    if (Result<void> drawn = session.drawTile(request_, target_); !drawn)
        return drawn;
    store(target_.readColour(), left, bottom);
    ++drawn_;
    return {};
}

/// Filters the samples of a tile to pixels of the picture. `left` and `bottom`: of the tile, in samples.
void LargePicture::store(const std::vector<std::uint8_t>& rgba, std::uint32_t left, std::uint32_t bottom) {
    const LinearMean mean;
    const std::uint32_t n = supersample_, firstX = left / n, firstY = bottom / n;
    const std::uint32_t columns = std::min(target_.width() / n, size_.width - firstX);
    const std::uint32_t rows = std::min(target_.height() / n, size_.height - firstY);
    const float share = 1.0f / static_cast<float>(n * n);
    for (std::uint32_t row = 0; row < rows; ++row) { // from the bottom, as tiles are placed
        const std::size_t below = target_.height() - std::size_t{row} * n - n; // sample row, from the top
        std::uint8_t* to = &rgb_[(std::size_t{size_.height - 1 - firstY - row} * size_.width + firstX) * 3];
        for (std::uint32_t column = 0; column < columns; ++column, to += 3) {
            const std::uint8_t* from = &rgba[(below * target_.width() + std::size_t{column} * n) * 4];
            for (std::size_t channel = 0; channel < 3; ++channel) {
                float sum = 0.0f;
                for (std::uint32_t i = 0; n > 1 && i < n * n; ++i)
                    sum += mean.linear(from[(std::size_t{i / n} * target_.width() + i % n) * 4 + channel]);
                to[channel] = n > 1 ? mean.encoded(sum * share) : from[channel];
            }
        }
    }
}

Result<std::vector<std::uint8_t>> drawLargePicture(Session& session, const FrameRequest& request,
                                                   const LargePictureOptions& options) {
    Result<LargePicture> picture = LargePicture::begin(session, request, options);
    if (!picture)
        return Failure(picture.error());
    while (!picture->isDone())
        if (Result<void> drawn = picture->drawNext(session); !drawn)
            return Failure(drawn.error());
    return picture->takeRgb();
}

} // namespace limen::engine
