#pragma once

#include <cstdint>

namespace limen::engine {

/// The mean of sRGB bytes in linear light.
class LinearMean {
public:
    LinearMean();
    /// Linear light of an sRGB byte, 0..1.
    [[nodiscard]] float linear(std::uint8_t value) const { return linear_[value]; }
    /// The nearest sRGB byte of a light, 0..1. Inverse of `linear`.
    [[nodiscard]] std::uint8_t encoded(float light) const;

private:
    static constexpr std::uint32_t kSteps = 16384; ///< the darkest bytes are 5 steps apart
    float linear_[256];
    std::uint8_t encoded_[kSteps + 1];
};

} // namespace limen::engine
