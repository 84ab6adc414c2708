#pragma once

#include <array>
#include <cstdint>

namespace limen::frame {

/// The colour that stands for an id in a frame shaded flat (gpu::Shading): R,G,B, 0..255, spread so that neighbouring
/// ids look nothing alike. Ids may share a colour: there are 2³² of the ones and 2²⁴ of the others. The shader
/// shaders/include/idcolour.glsl computes the same.
[[nodiscard]] constexpr std::array<std::uint8_t, 3> colourOfId(std::uint32_t id) {
    std::uint32_t mixed = (id + 1u) * 2654435761u;
    mixed = (mixed ^ (mixed >> 15)) * 2246822519u;
    mixed ^= mixed >> 13;
    return {static_cast<std::uint8_t>(mixed), static_cast<std::uint8_t>(mixed >> 8),
            static_cast<std::uint8_t>(mixed >> 16)};
}

} // namespace limen::frame
