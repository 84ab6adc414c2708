#pragma once

#include "gpu/device/Device.h"

#include <string_view>
#include <vector>

namespace limen::gpu {

/// A buffer and its size.
struct SizedBuffer {
    BufferHandle handle = BufferHandle::Invalid;
    std::size_t bytes = 0;
};

/// Buffers of released scenes, reused by later ones. Writing to fresh memory costs a frame several times as
/// much as the copy, because the system maps it page by page. The destructor destroys all; the device must
/// outlive it.
class SpareBuffers {
public:
    explicit SpareBuffers(Device& device) : device_(device) {}
    SpareBuffers(const SpareBuffers&) = delete;
    SpareBuffers& operator=(const SpareBuffers&) = delete;
    ~SpareBuffers() { clear(); }

    /// A buffer of `bytes` to twice as many, which the caller owns and fills from the beginning. Errors: the
    /// device's, if it lacks memory even after the spare buffers are destroyed.
    [[nodiscard]] Result<SizedBuffer> take(std::string_view label, std::size_t bytes);
    /// Creates a spare buffer of the same size and writes all of it, so that its memory is mapped now.
    /// Errors: the device's.
    [[nodiscard]] Result<void> addTwin(const SizedBuffer& of);
    /// Requires that no frame reads the buffer, in flight or later.
    void giveBack(const SizedBuffer& buffer) { spare_.push_back(buffer); }
    /// A scene is complete: buffers that are spare now will not be used.
    void endScene() { unused_ = spare_.size(); }
    /// Destroys one of those. False when there is none.
    bool releaseSome();
    /// Destroys all.
    void clear();

private:
    Device& device_;
    std::vector<SizedBuffer> spare_;
    std::size_t unused_ = 0; ///< number of the first buffers that will not be used
};

} // namespace limen::gpu
