#pragma once

#include "gpu/device/Device.h"

#include <utility>

namespace limen::gpu {

/// Owner of a device's object. The device must outlive it.
template <class Handle, void (Device::*kDestroy)(Handle)>
class Owned {
public:
    Owned() = default;
    Owned(Device& device, Handle handle) : device_(&device), handle_(handle) {}
    Owned(Owned&& other) noexcept
        : device_(other.device_), handle_(std::exchange(other.handle_, Handle::Invalid)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Owned() { reset(); }

    void reset() {
        if (handle_ != Handle::Invalid)
            (device_->*kDestroy)(std::exchange(handle_, Handle::Invalid));
    }
    [[nodiscard]] Handle get() const { return handle_; }
    [[nodiscard]] bool empty() const { return handle_ == Handle::Invalid; }

private:
    Device* device_ = nullptr;
    Handle handle_ = Handle::Invalid;
};

using OwnedBuffer = Owned<BufferHandle, &Device::destroyBuffer>;
using OwnedProgram = Owned<ProgramHandle, &Device::destroyProgram>;

} // namespace limen::gpu
