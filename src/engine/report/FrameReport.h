#pragma once

#include "gpu/DriverChoices.h"
#include "gpu/device/Device.h"
#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <optional>
#include <string>
#include <vector>

namespace limen::engine {

/// Work and time of one stage. A time that was not measured is NaN.
struct StageFigures {
    std::string name;
    std::uint32_t draws = 0;
    double cpuMs = 0.0, gpuMs = 0.0;
};

/// Figures of the last frame.
struct FrameFigures {
    std::string driver;
    std::string drawing;                       ///< way of drawing: "exact", "fast" or "traced"
    std::string textures;                      ///< "bindless" or "array pages"
    std::optional<gpu::DriverChoices> choices; ///< none: no driver drew
    std::vector<StageFigures> stages;
    std::uint32_t glCalls = 0;
    std::uint32_t ringStalls = 0; ///< so far: frames that waited for the GPU, plus growths of the ring
    std::size_t bytesWritten = 0; ///< into the ring, by this frame
    std::string trouble;          ///< as gpu::FrameReport::trouble
    gpu::DeviceObjects resident;
    double floodMs = 0.0, planMs = 0.0, submitMs = 0.0, gpuMs = 0.0;
};

/// Ids of the cells that any visit can see, ascending, without duplicates. The outside is not listed.
[[nodiscard]] std::vector<dat::RecordId> cellsSeen(const world::World& world,
                                                   const visibility::VisibleSet& visible);

/// A visit's region in NDC. Corners at the eye itself (w = 0) have no position on the screen and are left
/// out.
[[nodiscard]] std::vector<Vec2> regionNdc(const visibility::VisibleSet& visible,
                                          const visibility::Visit& visit);
/// The regions of all visits in NDC, by visit.
[[nodiscard]] std::vector<std::vector<Vec2>> regionOutlines(const visibility::VisibleSet& visible);

} // namespace limen::engine
