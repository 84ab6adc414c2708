#pragma once

#include "frame/GpuLayout.h"
#include "gpu/device/Device.h"

#include <vector>

namespace limen::gpu {

/// Transparent surfaces of one pixel (RenderOptions::wantLayers).
struct LayerSum {
    std::uint32_t count = 0;
    std::uint32_t hash = 0; ///< sum of layerHash(id) over the polygons (shaders/include/layers.glsl)
    friend bool operator==(const LayerSum&, const LayerSum&) = default;
};

/// The value that ownership is cleared to: the number of the root visit, whose zone this is, and kOwnedOutside.
[[nodiscard]] constexpr std::uint32_t rootOwner(std::uint32_t rootZone) {
    constexpr std::uint32_t kRootVisit = 0;
    return rootZone == frame::gpu::kOutside ? kRootVisit | frame::gpu::kOwnedOutside : kRootVisit;
}

/// A place in a larger picture: the tile's lower left corner, and the size of the whole picture, in pixels. The
/// tile may reach beyond the picture's right and upper edges; nothing is drawn there.
struct TilePlace {
    std::uint32_t x = 0, y = 0; ///< < 65536; even, because drivers shade 2 x 2 pixels together
    std::uint32_t pictureWidth = 0, pictureHeight = 0;
};

/// The images that a frame is drawn into. Read functions return the top row first and wait for the GPU.
class RenderTarget {
public:
    /// Errors: BadArgument for a size of 0 or beyond the driver's limit; Driver.
    [[nodiscard]] static Result<RenderTarget> create(Device& device, std::uint32_t width,
                                                     std::uint32_t height, const TargetOptions& options = {});
    RenderTarget(RenderTarget&& other) noexcept;
    RenderTarget& operator=(RenderTarget&& other) noexcept;
    ~RenderTarget();

    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }
    [[nodiscard]] const TargetOptions& options() const { return options_; }
    [[nodiscard]] TargetHandle handle() const { return handle_; }

    /// Makes the target a tile of a larger picture. Frames of one plan on all its tiles are the picture, with no
    /// seam. Requires the plan of the whole picture, and a picture that the driver allows
    /// (Capabilities::maxViewport). Distances of tiles cannot be read.
    void setTile(const TilePlace& tile) { tile_ = tile; }
    [[nodiscard]] bool isTile() const { return tile_.pictureWidth > 0; }
    [[nodiscard]] Viewport viewport() const;

    /// Sample positions of a multisampled target: pixels from the pixel's centre, x to the right, y
    /// downwards. Empty if the target is not multisampled.
    [[nodiscard]] std::vector<glm::vec2> samplePositions() const;

    /// Sets the constants that depend on the target: viewport, pixel size, the rays through its pixels (from
    /// clipFromEye, with the same rounding) and its sample positions. Requires samplesX and samplesY of 0.
    void place(const frame::gpu::ViewConstants& view, frame::gpu::DeviceConstants& device) const;

    /// R,G,B,A bytes; of a multisampled target the mean of its samples.
    [[nodiscard]] std::vector<std::uint8_t> readColour() const;
    /// kVoidId, kSkyId, or an id from the planner. Undefined after a frame without ids.
    [[nodiscard]] std::vector<std::uint32_t> readIds() const;
    /// Near plane / view depth; 0 where no surface was hit.
    [[nodiscard]] std::vector<float> readDepth() const;
    /// Number of the leaf visit.
    [[nodiscard]] std::vector<std::uint32_t> readOwnership() const;
    /// Transparent layers of a frame that counted them. Requires a target with a layers image.
    [[nodiscard]] std::vector<LayerSum> readLayers() const;
    /// Metres from the eye along the pixel's ray (frame::gpu::kPixelPlace), for the constants of the frame
    /// drawn last; +inf where no surface was hit.
    [[nodiscard]] std::vector<float> readDistances(const frame::gpu::ViewConstants& view) const;

private:
    RenderTarget(Device& device, TargetHandle handle, std::uint32_t width, std::uint32_t height,
                 const TargetOptions& options)
        : device_(&device), handle_(handle), width_(width), height_(height), options_(options) {}
    template <class T>
    [[nodiscard]] std::vector<T> read(TargetImage image, std::size_t perPixel) const;

    Device* device_ = nullptr;
    TargetHandle handle_ = TargetHandle::Invalid;
    std::uint32_t width_ = 0, height_ = 0;
    TargetOptions options_;
    TilePlace tile_;
    std::vector<glm::vec2> samples_; // from the lower left corner
};

} // namespace limen::gpu
