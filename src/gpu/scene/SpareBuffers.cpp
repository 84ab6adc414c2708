#include "gpu/scene/SpareBuffers.h"

#include <algorithm>
#include <array>
#include <bit>

namespace limen::gpu {
namespace {

constexpr std::size_t kSmallest = std::size_t{64} << 10; // bytes: smaller buffers count as this size

/// Capacity for `bytes` and up to a quarter more, so that a somewhat longer array fits later.
std::size_t withRoom(std::size_t bytes) {
    const std::size_t step = std::bit_floor(bytes > kSmallest ? bytes : kSmallest) / 4;
    return (bytes + step - 1) / step * step;
}

} // namespace

Result<SizedBuffer> SpareBuffers::take(std::string_view label, std::size_t bytes) {
    const std::size_t most = 2 * std::max(bytes, kSmallest);
    auto best = spare_.end();
    for (auto at = spare_.begin(); at != spare_.end(); ++at)
        if (at->bytes >= bytes && at->bytes <= most && (best == spare_.end() || at->bytes < best->bytes))
            best = at;
    if (best != spare_.end()) {
        const SizedBuffer found = *best;
        unused_ -= static_cast<std::size_t>(best - spare_.begin()) < unused_ ? 1 : 0;
        spare_.erase(best);
        device_.refillBuffer(label, found.handle);
        return found;
    }
    // A buffer that can be texels is not enlarged beyond the limit for texels.
    const std::size_t longest = device_.capabilities().maxBufferTexels * kBytesPerTexel;
    const std::size_t size = bytes > longest ? bytes : std::min(withRoom(bytes), longest);
    Result<BufferHandle> reserved = device_.reserveBuffer(label, size);
    if (!reserved && !spare_.empty()) {
        clear();
        device_.finishFrames(); // drivers free destroyed objects only then
        reserved = device_.reserveBuffer(label, size);
    }
    return reserved.map([&](BufferHandle handle) { return SizedBuffer{handle, size}; });
}

Result<void> SpareBuffers::addTwin(const SizedBuffer& of) {
    static constexpr std::array<std::byte, 1 << 16> kNothing{};
    const Result<BufferHandle> twin = device_.reserveBuffer("spare", of.bytes);
    if (!twin)
        return Failure(twin.error());
    for (std::size_t at = 0; at < of.bytes; at += kNothing.size())
        device_.writeBuffer(*twin, at, std::span(kNothing).first(std::min(kNothing.size(), of.bytes - at)));
    giveBack({*twin, of.bytes});
    return {};
}

bool SpareBuffers::releaseSome() {
    if (unused_ == 0)
        return false;
    device_.destroyBuffer(spare_.front().handle);
    spare_.erase(spare_.begin());
    --unused_;
    return true;
}

void SpareBuffers::clear() {
    for (const SizedBuffer& buffer : spare_)
        device_.destroyBuffer(buffer.handle);
    spare_.clear();
    unused_ = 0;
}

} // namespace limen::gpu
