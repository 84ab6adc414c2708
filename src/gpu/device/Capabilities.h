#pragma once

#include "core/Error.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace limen::gpu {

/// What the driver offers, as far as the renderer chooses by it. The defaults are GL 4.5's minima or what the
/// null device pretends.
struct Capabilities {
    std::string vendor, renderer, version;
    bool bindless = false;           ///< ARB_bindless_texture
    bool software = false;           ///< a rasteriser on the CPU: costly filters stay off
    float maxAnisotropy = 1.0f;      ///< 1: none
    std::uint32_t textureUnits = 16; ///< of the fragment stage
    std::uint32_t maxTextureSize = 16384, maxArrayLayers = 2048;
    std::uint32_t maxSamples = 4; ///< a pixel, of colour, depth and integer images alike; 1: no multisampling
    std::uint32_t maxBufferTexels = 65536; ///< of a buffer that is read as a texture
    std::size_t storageAlignment = 256;    ///< of offsets of what is bound of the ring memory, bytes
};

/// Asks the current context. Errors: Driver, with one message that names everything needed and missing, and
/// the driver.
[[nodiscard]] Result<Capabilities> queryCapabilities();

/// Whether a driver can draw with so many samples a pixel (0 and 1: always). Errors: BadArgument for a number that the
/// shaders are not made for; Driver, naming it and what it has.
[[nodiscard]] Result<void> checkSamples(std::uint32_t samples, const Capabilities& capabilities);

/// What `queryCapabilities` finds missing, for its message; empty on a good driver.
struct DriverLimits {
    int version = 0; ///< 45 for 4.5
    bool shaderDrawParameters = false, coreProfile = false;
    int vertexStorageBlocks = 0, fragmentStorageBlocks = 0, combinedStorageBlocks = 0, storageBindings = 0;
    int computeStorageBlocks = 0;
    int textureUnits = 0, vertexTextureUnits = 0, computeTextureUnits = 0, drawBuffers = 0;
};
[[nodiscard]] std::vector<std::string> missingFrom(const DriverLimits& limits);

} // namespace limen::gpu
