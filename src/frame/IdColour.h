#pragma once

#include <array>
#include <cstdint>

namespace limen::frame {

/// The colour that stands for an id in a frame shaded flat (gpu::Shading): R,G,B, 0..255. Neighbouring ids
/// get very different colours. Ids may share a colour: there are 2³² ids and 2²⁴ colours. Same function as in
/// shaders/include/idcolour.glsl.
[[nodiscard]] constexpr std::array<std::uint8_t, 3> colourOfId(std::uint32_t id) {
    std::uint32_t mixed = (id + 1u) * 2654435761u;
    mixed = (mixed ^ (mixed >> 15)) * 2246822519u;
    mixed ^= mixed >> 13;
    return {static_cast<std::uint8_t>(mixed), static_cast<std::uint8_t>(mixed >> 8),
            static_cast<std::uint8_t>(mixed >> 16)};
}

} // namespace limen::frame
