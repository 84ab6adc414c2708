#pragma once

#include "cli/Parse.h"
#include "visibility/View.h"

namespace limen::engine {

/// A direction of sight, in degrees: yaw 0 north (+Y), 90 east (+X); pitch 90 straight up.
struct Heading {
    double yaw = 0.0, pitch = 0.0;
};

/// An eye and its perspective, as people give it.
struct Camera {
    Vec3 eye{0.0}; ///< global
    Heading heading;
    double fovDegrees = 60.0; ///< vertical
};

/// Right, up and forward, orthonormal. Multiples of 90 degrees give exact axes.
struct CameraBasis {
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};
};
[[nodiscard]] CameraBasis basisOf(const Heading& heading);

/// The heading that looks along a direction of any length but zero; straight up or down has yaw 0.
[[nodiscard]] Heading headingOf(const Vec3& direction);

/// The view that the flood takes. `root` is an index of the graph's spaces.
[[nodiscard]] visibility::View viewOf(const Camera& camera, cli::PixelSize size, std::uint32_t root);

} // namespace limen::engine
