#include "gpu/DepthTiles.h"

#include "core/Assert.h"

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

// Ranges start at multiples of 256 bytes, the largest alignment that drivers require.
constexpr std::size_t kTilesPerStep = 256 / sizeof(float);

std::uint32_t tilesAcross(std::uint32_t pixels) {
    return (pixels + layout::kTileSize - 1) / layout::kTileSize;
}

} // namespace

Result<void> DepthTiles::prepare(std::uint32_t width, std::uint32_t height) {
    count_ = tilesAcross(width) * tilesAcross(height);
    if (count_ > capacity_) {
        const std::size_t capacity = (count_ + kTilesPerStep - 1) / kTilesPerStep * kTilesPerStep;
        capacity_ = 0;
        buffer_.reset();
        const Result<BufferHandle> made =
            device_->createScratch("depth tiles", capacity * kFramesInFlight * sizeof(float));
        if (!made)
            return Failure(made.error());
        buffer_ = {*device_, *made};
        capacity_ = capacity;
    }
    place_ = (place_ + 1) % kFramesInFlight; // earlier frames still read theirs
    return {};
}

StorageRange DepthTiles::range() const {
    LIMEN_ASSERT(!buffer_.empty(), "prepared");
    return {buffer_.get(), place_ * capacity_ * sizeof(float), capacity_ * sizeof(float)};
}

} // namespace limen::gpu
