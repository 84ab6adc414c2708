#pragma once

#include "gpu/device/ForwardingDevice.h"

namespace limen::gpu::test {

/// A device that fails on request, like a driver that lacks memory for a while or is reset.
class FailingDevice final : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    /// Number of buffers and textures created before `failures` requests fail; none: no failure.
    std::optional<std::uint32_t> madeBeforeFailure;
    std::uint32_t failures = 1;
    /// Number of scratch buffer requests that fail.
    std::uint32_t scratchFailures = 0, scratchRequests = 0;
    bool isReset = false;

    [[nodiscard]] Result<BufferHandle> createBuffer(std::string_view label,
                                                    std::span<const std::byte> bytes) override {
        return failsNow() ? outOfMemory(label) : device().createBuffer(label, bytes);
    }
    [[nodiscard]] Result<BufferHandle> reserveBuffer(std::string_view label, std::size_t bytes) override {
        return failsNow() ? outOfMemory(label) : device().reserveBuffer(label, bytes);
    }
    [[nodiscard]] Result<BufferHandle> createScratch(std::string_view label, std::size_t bytes) override {
        ++scratchRequests;
        if (scratchFailures > 0) {
            --scratchFailures;
            return outOfMemory(label);
        }
        return device().createScratch(label, bytes);
    }
    [[nodiscard]] Result<TextureHandle> createTexels(std::string_view label, BufferHandle buffer) override {
        return failsNow() ? outOfMemory(label) : device().createTexels(label, buffer);
    }
    [[nodiscard]] Result<TextureHandle> createTexture(std::string_view label,
                                                      const TextureShape& shape) override {
        return failsNow() ? outOfMemory(label) : device().createTexture(label, shape);
    }
    [[nodiscard]] Result<void> endFrame() override {
        Result<void> ended = device().endFrame();
        return isReset ? fail(ErrorCode::Driver, "a driver", "was reset") : ended;
    }

private:
    static Failure outOfMemory(std::string_view label) {
        return fail(ErrorCode::Driver, std::string(label), "out of memory");
    }
    bool failsNow() {
        if (!madeBeforeFailure)
            return false;
        if (*madeBeforeFailure > 0) {
            --*madeBeforeFailure;
            return false;
        }
        if (--failures == 0)
            madeBeforeFailure.reset();
        return true;
    }
};

} // namespace limen::gpu::test
