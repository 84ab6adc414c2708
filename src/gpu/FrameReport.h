#pragma once

#include "frame/FramePlan.h"

#include <array>
#include <optional>
#include <string>

namespace limen::gpu {

/// What one stage of a frame did.
struct StageReport {
    frame::StageKind kind = frame::StageKind::Ownership;
    std::uint32_t draws = 0;   ///< draw commands; 1 for ownership and the plain sky where they draw anything
    std::uint32_t batches = 0; ///< GL draw calls
    double cpuMs = 0.0;
    std::optional<double> gpuMs; ///< of the latest frame whose timer results have arrived
};

/// What the last frame did.
struct FrameReport {
    std::uint32_t glCalls = 0; ///< all of them, timer queries apart
    double cpuMs = 0.0;        ///< the whole of Renderer::render
    std::array<StageReport, frame::kStageCount> stages;
    std::uint32_t ringStalls = 0; ///< since the device was made
    std::size_t bytesWritten = 0; ///< ring memory that the frame took
    std::string trouble;          ///< what it went on without, and why, for a person; empty: nothing
};

/// What the renderer runs on.
struct DriverReport {
    std::string vendor, renderer, version;
    const char* textureMode = "";        ///< "bindless" or "array pages"
    std::uint32_t pages = 0;             ///< array textures bound
    std::uint32_t resampledTextures = 0; ///< stored larger than they are, for want of pages
};

} // namespace limen::gpu
