#include "engine/picture/LinearFilter.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::engine {
namespace {

double lightOf(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double valueOf(double light) {
    return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

} // namespace

LinearMean::LinearMean() {
    for (int i = 0; i < 256; ++i)
        linear_[i] = static_cast<float>(lightOf(i / 255.0));
    for (std::uint32_t i = 0; i <= kSteps; ++i)
        encoded_[i] =
            static_cast<std::uint8_t>(std::lround(255.0 * valueOf(static_cast<double>(i) / kSteps)));
}

std::uint8_t LinearMean::encoded(float light) const {
    LIMEN_ASSERT(!std::isnan(light), "the mean of some bytes");
    const float step = std::clamp(light, 0.0f, 1.0f) * static_cast<float>(kSteps);
    return encoded_[static_cast<std::uint32_t>(step + 0.5f)];
}

} // namespace limen::engine
