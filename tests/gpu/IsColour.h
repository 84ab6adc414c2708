#pragma once

#include <cstdlib>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>

namespace limen::gpu::test {

/// A colour within one step of 255 in each channel. OpenGL 4.5, 2.3.5.2, does not say how a value halfway between two
/// steps is rounded: llvmpipe rounds up, NVIDIA's driver down.
MATCHER_P3(IsColour, red, green, blue, "") {
    *result_listener << "(" << arg.x << ", " << arg.y << ", " << arg.z << ")";
    return std::abs(arg.x - red) <= 1 && std::abs(arg.y - green) <= 1 && std::abs(arg.z - blue) <= 1;
}

} // namespace limen::gpu::test
