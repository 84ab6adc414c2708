#pragma once

#include "core/Error.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace limen::gpu {

/// Properties of the driver that the renderer depends on. Defaults: the minima of OpenGL 4.5, or values for
/// the null device.
struct Capabilities {
    std::string vendor, renderer, version;
    bool bindless = false;           ///< ARB_bindless_texture
    bool software = false;           ///< rasterises on the CPU: expensive filters are off
    float maxAnisotropy = 1.0f;      ///< 1: none
    std::uint32_t textureUnits = 16; ///< of the fragment stage
    std::uint32_t maxTextureSize = 16384, maxArrayLayers = 2048;
    std::uint32_t maxViewport = 16384; ///< side of a picture in pixels, also of one drawn in tiles
    /// per pixel, for colour, depth and integer images alike; 1: no multisampling
    std::uint32_t maxSamples = 4;
    std::uint32_t maxBufferTexels = 65536; ///< of a buffer read as a texture
    std::size_t storageAlignment = 256;    ///< of offsets in ring memory, bytes, for every use of a buffer
};

/// Queries the current context. Errors: Driver, with one message that names the driver and every missing
/// feature.
[[nodiscard]] Result<Capabilities> queryCapabilities();

/// Whether a driver supports this number of samples per pixel (0 and 1: always). Errors: BadArgument for a
/// number that the shaders do not support; Driver, naming it and its limit.
[[nodiscard]] Result<void> checkSamples(std::uint32_t samples, const Capabilities& capabilities);

/// Limits that queryCapabilities compares with the renderer's needs.
struct DriverLimits {
    int version = 0; ///< 45 for 4.5
    bool shaderDrawParameters = false, coreProfile = false;
    int vertexStorageBlocks = 0, fragmentStorageBlocks = 0, combinedStorageBlocks = 0, storageBindings = 0;
    int computeStorageBlocks = 0;
    int textureUnits = 0, vertexTextureUnits = 0, computeTextureUnits = 0, drawBuffers = 0;
};
[[nodiscard]] std::vector<std::string> missingFrom(const DriverLimits& limits);

} // namespace limen::gpu
