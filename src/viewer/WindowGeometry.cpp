#include "viewer/WindowGeometry.h"

#include <algorithm>
#include <cmath>

namespace limen::viewer {

std::optional<PixelPlace> pixelAt(const WindowSizes& sizes, double x, double y) {
    if (!(x >= 0.0 && y >= 0.0 && x < sizes.width && y < sizes.height))
        return std::nullopt;
    return PixelPlace{static_cast<std::uint32_t>(x * sizes.pixels.width / sizes.width),
                      static_cast<std::uint32_t>(y * sizes.pixels.height / sizes.height)};
}

UiScale uiScaleOf(const WindowSizes& sizes) {
    constexpr double kSmallest = 0.5, kLargest = 8.0;
    const double wanted = std::isfinite(sizes.contentScale) ? sizes.contentScale : 1.0;
    UiScale scale;
    scale.pixels = std::clamp(wanted, kSmallest, kLargest);
    const double pixelsAUnit = sizes.width > 0 ? static_cast<double>(sizes.pixels.width) / sizes.width : 1.0;
    scale.units = scale.pixels / std::max(pixelsAUnit, 1e-3);
    return scale;
}

} // namespace limen::viewer
