#pragma once

#include "gpu/RendererOptions.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace limen::test {

/// For tests whose result must be the same in every culling mode.
inline auto everyCulling() {
    return ::testing::Values(gpu::Culling::None, gpu::Culling::Unseen, gpu::Culling::Hidden);
}

inline std::string nameOfCulling(const ::testing::TestParamInfo<gpu::Culling>& culling) {
    constexpr std::array<const char*, 3> kNames{"none", "unseen", "hidden"};
    return kNames[static_cast<std::size_t>(culling.param)];
}

} // namespace limen::test
