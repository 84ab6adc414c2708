#pragma once

#include "gpu/RendererOptions.h"
#include "gpu/device/Capabilities.h"

#include <string>
#include <vector>

namespace limen::gpu {

/// All decisions about drawing that depend on the driver. They change the cost of pictures and the smoothness of
/// textures, never the visible surfaces.
struct DriverChoices {
    bool software = false; ///< the driver rasterises on the processor
    Drawing drawing = Drawing::Exact;
    bool bindless = false;           ///< textures by handle
    bool pagesByIndex = false;       ///< TextureStoreOptions::pagesByIndex
    bool atlas = false;              ///< textures of meshes and sky in an atlas, if they fit
    bool packsTerrain = false;       ///< layers of landcells in 16 bytes each
    bool nearestLevel = false;       ///< one mip level a sample
    float anisotropy = 1.0f;         ///< limit; 1: off
    std::uint32_t samples = 1;       ///< per pixel, in frames without ids
    bool computes = false;           ///< a compute pass writes the draw commands; else the processor does
    Culling culling = Culling::None; ///< triangles that compute passes skip
    bool overlaps = false;           ///< rasterises walls and ground while it transforms the rest
    bool rootFirst = false;          ///< plans from outside have FrameView::rootFirst
    bool occludes = false;           ///< plans leave out instances that land and buildings hide
};

/// Decides for a driver. `samples`: per pixel, as the options ask for.
[[nodiscard]] DriverChoices driverChoices(const RendererOptions& options, const Capabilities& capabilities,
                                          std::uint32_t samples = 0);

/// One decision as text.
struct DriverChoice {
    const char* name;   ///< a key, e.g. "mip_levels"
    std::string value;  ///< e.g. "nearest"
    const char* reason; ///< of this value
};
/// Every decision, in a fixed order.
[[nodiscard]] std::vector<DriverChoice> describe(const DriverChoices& choices);

} // namespace limen::gpu
