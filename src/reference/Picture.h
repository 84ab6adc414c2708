#pragma once

#include "reference/Scene.h"

#include <vector>

namespace limen::reference {

/// An eye and its perspective. The same quantities as frame::FrameView; the rooms share no types.
struct Camera {
    Vec3 eye{0.0};                                      ///< global
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0}; ///< orthonormal
    double tanHalfX = 1.0, tanHalfY = 1.0;              ///< tangents of half the field of view
    std::uint32_t width = 640, height = 360;            ///< pixels
    double nearPlane = kDefaultNearPlane;               ///< metres
    Vec2 place{0.0}; ///< sample position: pixels from a pixel's centre, y downwards
    world::SpaceIndex root = world::kOutside;
};

/// The ray of a pixel; (0, 0) is the top left one. Fractions, and positions beyond the border, are allowed.
[[nodiscard]] Ray rayThrough(const Camera& camera, double x, double y);

/// The right answer for each pixel, with a border of one pixel all around.
struct Picture {
    std::uint32_t width = 0, height = 0; ///< without the border
    std::vector<Answer> answers;         ///< (width + 2) × (height + 2), top row first
    [[nodiscard]] const Answer& at(int x, int y) const {
        return answers[static_cast<std::size_t>(y + 1) * (width + 2) + static_cast<std::size_t>(x + 1)];
    }
};

/// Traces a whole picture on `threads` threads; overwrites `out`. The answers do not depend on the number of
/// threads.
void tracePicture(const Scene& scene, const Camera& camera, unsigned threads, Picture& out);

} // namespace limen::reference
