#pragma once

#include "gpu/device/Device.h"

#include <string_view>
#include <vector>

namespace limen::gpu {

/// A buffer with how much it holds.
struct SizedBuffer {
    BufferHandle handle = BufferHandle::Invalid;
    std::size_t bytes = 0;
};

/// Buffers of scenes that are gone, for those that come: to write where nothing was before costs a frame several times what the
/// writing does, for the system then finds memory page by page. Gives everything back when it goes; the device must outlive it.
class SpareBuffers {
public:
    explicit SpareBuffers(Device& device) : device_(device) {}
    SpareBuffers(const SpareBuffers&) = delete;
    SpareBuffers& operator=(const SpareBuffers&) = delete;
    ~SpareBuffers() { clear(); }

    /// One for at least `bytes`, to be filled from its beginning on; the caller's from then on. It may be longer, at most twice. Errors:
    /// the device's, if it has no memory even without what is spare.
    [[nodiscard]] Result<SizedBuffer> take(std::string_view label, std::size_t bytes);
    /// Makes one as long as another, and writes all of it: its memory is found now. Errors: the device's.
    [[nodiscard]] Result<void> addTwin(const SizedBuffer& of);
    /// Requires that no frame reads it any more, those under way included.
    void giveBack(const SizedBuffer& buffer) { spare_.push_back(buffer); }
    /// A scene has all that it needs: what is spare now is of no use.
    void endScene() { unused_ = spare_.size(); }
    /// Gives one of those back. False when there is none.
    bool releaseSome();
    /// Gives all back.
    void clear();

private:
    Device& device_;
    std::vector<SizedBuffer> spare_;
    std::size_t unused_ = 0; ///< the first of these
};

} // namespace limen::gpu
