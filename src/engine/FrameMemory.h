#pragma once

#include "engine/Camera.h"
#include "gpu/device/Capabilities.h"

#include <cstdint>
#include <optional>
#include <string_view>

// Memory for pictures, tested before a world is loaded.
namespace limen::engine {

/// Bytes of the images of one frame.
struct FrameMemory {
    std::uint64_t device = 0; ///< render targets; in main memory with a software driver
    std::uint64_t host = 0;   ///< copies for the files
};
/// `samples`: per pixel, 0 and 1: one. Above one, a second target serves ids and depth.
[[nodiscard]] FrameMemory frameMemory(PixelSize size, std::uint32_t samples);

/// Bytes of main memory that the system can give to programs without swapping; none: unknown.
[[nodiscard]] std::optional<std::uint64_t> availableMemory();

/// Errors: BadArgument, if `subject` ("a picture of 640x360") needs more bytes than `available`; `option` is
/// the option to make smaller. Unknown memory is enough.
[[nodiscard]] Result<void> checkMemory(std::string_view option, std::string_view subject,
                                       std::uint64_t needed, std::optional<std::uint64_t> available);

/// Tests a frame against the driver's largest picture and the free memory. Errors: BadArgument, for --size.
[[nodiscard]] Result<void> checkFrameFits(PixelSize size, std::uint32_t samples,
                                          const gpu::Capabilities& capabilities,
                                          std::optional<std::uint64_t> available);

} // namespace limen::engine
