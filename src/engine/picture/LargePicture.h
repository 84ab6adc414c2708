#pragma once

#include "engine/Session.h"

#include <cstdint>
#include <optional>
#include <vector>

// Pictures larger than a render target, and supersampled pictures, drawn tile by tile with bounded memory.
namespace limen::engine {

inline constexpr std::uint32_t kMostSupersampling = 8;

/// A picture in samples: `supersample` x `supersample` of them are filtered to one pixel.
struct LargePictureOptions {
    std::uint32_t supersample = 1; ///< 1..kMostSupersampling
    std::uint32_t tileSide = 2048; ///< samples; rounded down to whole, even numbers of pixels
};

/// Errors: BadArgument for a picture of more than kMaxSide samples a side, or more than the driver draws; the
/// message names the largest supersampling that fits.
[[nodiscard]] Result<void> checkLargePicture(PixelSize size, std::uint32_t supersample,
                                             std::uint32_t maxViewport = kMaxSide);

/// The memory for drawing such a picture, in bytes, on the CPU and on the device together. `samples`: as
/// SessionOptions::samples. Without the scene, and without the encoded file.
[[nodiscard]] std::uint64_t bytesOfLargePicture(PixelSize size, const LargePictureOptions& options,
                                                std::uint32_t samples);

/// A picture being drawn. Each call of `drawNext` draws one tile, so that a window can show progress. All
/// tiles are drawn from the plan of the whole picture, and shaders compute with positions in the whole picture:
/// tiles join without a seam. The union of the tiles equals the picture in one piece, up to the rounding of the
/// driver's interpolation (TilesGlTest). The loaded part must stay the same.
class LargePicture {
public:
    /// `request`: with the size of the finished picture in pixels. Errors: as checkLargePicture; Driver.
    [[nodiscard]] static Result<LargePicture> begin(Session& session, FrameRequest request,
                                                    const LargePictureOptions& options);

    [[nodiscard]] std::size_t tiles() const { return tiles_; }
    [[nodiscard]] std::size_t drawn() const { return drawn_; }
    [[nodiscard]] bool isDone() const { return drawn_ == tiles_; }
    /// Draws the next tile. Requires that it is not done. Errors: the session's.
    [[nodiscard]] Result<void> drawNext(Session& session);
    /// R, G, B bytes, sRGB, top row first; black where no tile was drawn yet.
    [[nodiscard]] const std::vector<std::uint8_t>& rgb() const { return rgb_; }
    [[nodiscard]] std::vector<std::uint8_t> takeRgb() { return std::move(rgb_); }
    [[nodiscard]] PixelSize size() const { return size_; }

private:
    LargePicture(gpu::RenderTarget target, FrameRequest request, PixelSize size, std::uint32_t supersample);
    void store(const std::vector<std::uint8_t>& rgba, std::uint32_t left, std::uint32_t bottom);

    gpu::RenderTarget target_;
    FrameRequest request_; ///< with its size in samples
    PixelSize size_;       ///< pixels
    std::uint32_t supersample_ = 1, columns_ = 1;
    std::size_t tiles_ = 0, drawn_ = 0;
    std::vector<std::uint8_t> rgb_;
};

/// Draws all tiles.
[[nodiscard]] Result<std::vector<std::uint8_t>>
drawLargePicture(Session& session, const FrameRequest& request, const LargePictureOptions& options);

} // namespace limen::engine
