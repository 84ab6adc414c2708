#pragma once

#include "frame/FramePlan.h"

#include <array>
#include <optional>
#include <string>

namespace limen::gpu {

/// Counts and times of one stage.
struct StageReport {
    frame::StageKind kind = frame::StageKind::Ownership;
    std::uint32_t draws = 0;   ///< draw commands; for ownership and the plain sky 1 if they draw anything
    std::uint32_t batches = 0; ///< GL draw calls
    double cpuMs = 0.0;
    std::optional<double> gpuMs; ///< of the latest frame with timer results; none if a stage was repeated
};

/// Counts and times of the last frame.
struct FrameReport {
    std::uint32_t glCalls = 0; ///< without timer queries
    double cpuMs = 0.0;        ///< of Renderer::render
    std::array<StageReport, frame::kStageCount> stages;
    std::uint32_t ringStalls = 0; ///< since the device was created
    std::size_t bytesWritten = 0; ///< ring memory used
    std::string trouble;          ///< message: a feature that is off and the reason; empty: none
};

/// Driver and texture binding.
struct DriverReport {
    std::string vendor, renderer, version;
    const char* textureMode = "";        ///< "bindless" or "array pages"
    std::uint32_t pages = 0;             ///< array textures bound
    std::uint32_t resampledTextures = 0; ///< stored enlarged because there are fewer pages than sizes
};

} // namespace limen::gpu
