#include "gpu/DepthTiles.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

// Ranges begin at whole multiples of what any driver asks for: 256 bytes.
constexpr std::size_t kTilesPerStep = 256 / sizeof(float);

std::uint32_t tilesAcross(std::uint32_t pixels) {
    return (pixels + layout::kTileSize - 1) / layout::kTileSize;
}

} // namespace

Result<DepthTiles> DepthTiles::create(Device& device, std::span<const std::string> defines) {
    const ProgramSource source{
        .label = "tiles", .defines = {defines.begin(), defines.end()}, .computeShader = "tiles.comp"};
    return device.createProgram(source).map(
        [&](ProgramHandle program) { return DepthTiles(device, OwnedProgram(device, program)); });
}

void DepthTiles::prepare(std::uint32_t width, std::uint32_t height) {
    columns_ = tilesAcross(width);
    rows_ = tilesAcross(height);
    LIMEN_ASSERT(rows_ <= kMostGroups, "no picture is that high");
    const std::size_t tiles = std::size_t{columns_} * rows_;
    if (tiles > capacity_) {
        capacity_ = (tiles + kTilesPerStep - 1) / kTilesPerStep * kTilesPerStep;
        buffer_.reset();
        buffer_ = {*device_,
                   device_->createScratch("depth tiles", capacity_ * kFramesInFlight * sizeof(float))};
    }
    place_ = (place_ + 1) % kFramesInFlight; // frames before still read their own
}

StorageRange DepthTiles::range() const {
    LIMEN_ASSERT(!buffer_.empty(), "prepared");
    return {buffer_.get(), place_ * capacity_ * sizeof(float), capacity_ * sizeof(float)};
}

void DepthTiles::run() {
    device_->compute(program_.get(), (columns_ + layout::kTileThreads - 1) / layout::kTileThreads, rows_);
}

} // namespace limen::gpu
