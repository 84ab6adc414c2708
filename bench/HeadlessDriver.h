#pragma once

#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"

#include <memory>
#include <optional>

namespace limen::bench {

/// An OpenGL context and device without a window.
struct HeadlessDriver {
    gpu::HeadlessContext context;
    std::unique_ptr<gpu::GlDevice> device;
};

/// None: no driver on this machine offers such a context.
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
