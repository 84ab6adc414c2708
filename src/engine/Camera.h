#pragma once

#include "geometry/Vec.h"
#include "visibility/View.h"

#include <cstdint>

namespace limen::engine {

/// Width and height of a picture in pixels.
struct PixelSize {
    std::uint32_t width = 1280, height = 720;
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// The largest width or height of a picture, in pixels.
inline constexpr std::uint32_t kMaxSide = 16384;

/// A viewing direction in degrees: yaw 0 is north (+Y), 90 is east (+X); pitch 90 is straight up.
struct Heading {
    double yaw = 0.0, pitch = 0.0;
};

/// A perspective camera as a user describes it.
struct Camera {
    Vec3 eye{0.0}; ///< global, metres
    Heading heading;
    double fovDegrees = 60.0; ///< vertical
    PixelSize shape{0, 0};    ///< width and height of the view are in this ratio; {0, 0}: in the picture's
};

/// Right, up and forward, orthonormal. Multiples of 90 degrees give exact axes.
struct CameraBasis {
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};
};
[[nodiscard]] CameraBasis basisOf(const Heading& heading);

/// The heading of a direction. Its length is arbitrary but not 0. Straight up and straight down have yaw 0.
[[nodiscard]] Heading headingOf(const Vec3& direction);

/// Size of a picture of `percent` per cent of the pixels each way; at least 1x1. 0 < percent <= 100.
[[nodiscard]] PixelSize scaledSize(PixelSize size, std::uint32_t percent);

/// The camera as the flood takes it. `root` is an index of the graph's spaces. Requires a size with pixels
/// and a field of view between 0 and 180 degrees.
[[nodiscard]] visibility::View viewOf(const Camera& camera, PixelSize size, std::uint32_t root);

} // namespace limen::engine
