#pragma once

#include "gpu/ForwardingDevice.h"

namespace limen::gpu::test {

/// Another device whose next requests for textures fail when told to: a driver short of memory for a moment.
class FailingDevice final : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    /// Textures, of buffers too, that are still made before one fails, once; none: all are made.
    std::optional<std::uint32_t> texturesBeforeFailure;

    [[nodiscard]] Result<TextureHandle> createTexels(std::string_view label, BufferHandle buffer) override {
        return failsNow() ? fail(ErrorCode::Driver, std::string(label), "out of memory")
                          : device().createTexels(label, buffer);
    }
    [[nodiscard]] Result<TextureHandle> createTexture(std::string_view label,
                                                      const TextureShape& shape) override {
        return failsNow() ? fail(ErrorCode::Driver, std::string(label), "out of memory")
                          : device().createTexture(label, shape);
    }

private:
    bool failsNow() {
        const bool fails = texturesBeforeFailure && (*texturesBeforeFailure)-- == 0;
        if (fails) {
            texturesBeforeFailure.reset();
        }
        return fails;
    }
};

} // namespace limen::gpu::test
