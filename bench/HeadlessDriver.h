#pragma once

#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"

#include <memory>
#include <optional>

namespace limen::bench {

/// A driver without a window.
struct HeadlessDriver {
    gpu::HeadlessContext context;
    std::unique_ptr<gpu::GlDevice> device;
};

/// None where there is no driver that can do it.
[[nodiscard]] inline std::optional<HeadlessDriver> openDriver() {
    Result<gpu::HeadlessContext> context = gpu::HeadlessContext::create();
    if (!context)
        return {};
    Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return {};
    return HeadlessDriver{std::move(*context), std::move(*device)};
}

} // namespace limen::bench
