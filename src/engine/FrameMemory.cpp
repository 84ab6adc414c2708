#include "engine/FrameMemory.h"

#include "core/platform/Process.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>

namespace limen::engine {
namespace {

// Bytes a pixel (gpu/device/GlDeviceResources.cpp, makeImages).
constexpr std::uint64_t kPlainTarget = 16;   ///< colour, depth, ownership, id
constexpr std::uint64_t kSampledTarget = 12; ///< colour, depth, ownership, for each sample
constexpr std::uint64_t kResolved = 4;
/// The colour as read, the picture, its file; ids and depth are read when the colour is released.
constexpr std::uint64_t kHostCopies = 4 + 3 + 3;

double gigabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1e9;
}

} // namespace

FrameMemory frameMemory(PixelSize size, std::uint32_t samples) {
    const std::uint64_t pixels = std::uint64_t{size.width} * size.height;
    const std::uint64_t sampled = samples > 1 ? kSampledTarget * samples + kResolved : 0;
    return {pixels * (kPlainTarget + sampled), pixels * kHostCopies};
}

std::optional<std::uint64_t> availableMemory() {
    return platform::systemMemory().available;
}

Result<void> checkMemory(std::string_view option, std::string_view subject, std::uint64_t needed,
                         std::optional<std::uint64_t> available) {
    if (!available || needed <= *available)
        return {};
    return fail(ErrorCode::BadArgument, std::string(option),
                fmt::format("{} needs {:.1f} GB of memory, and {:.1f} GB are free; choose a smaller number",
                            subject, gigabytes(needed), gigabytes(*available)));
}

Result<void> checkFrameFits(PixelSize size, std::uint32_t samples, const gpu::Capabilities& capabilities,
                            std::optional<std::uint64_t> available) {
    if (std::max(size.width, size.height) > capabilities.maxTextureSize)
        return fail(
            ErrorCode::BadArgument, "--size",
            fmt::format("{}x{} is beyond this driver's limit of {} pixels per side; choose a smaller size",
                        size.width, size.height, capabilities.maxTextureSize));
    const FrameMemory memory = frameMemory(size, samples);
    return checkMemory("--size", fmt::format("a picture of {}x{}", size.width, size.height),
                       memory.host + (capabilities.software ? memory.device : 0), available);
}

} // namespace limen::engine
