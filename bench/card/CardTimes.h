#pragma once

#include "frames/LimenWays.h"

#include "world/Places.h"

#include <array>
#include <string>
#include <vector>

namespace limen::bench {

/// A way of drawing that is timed on the card.
struct CardWay {
    std::string name; ///< "fast/bindless"
    gpu::RendererOptions options;
};

/// Milliseconds of GPU time of one place: medians over the repeats.
struct CardTime {
    double frame = 0.0;                              ///< from the frame's first command to its last
    std::array<double, frame::kStageCount> stages{}; ///< by frame::StageKind; 0: the driver gave no time
};

/// The times of one way in pictures of one size.
struct CardTimes {
    std::uint32_t width = 0, height = 0; ///< pixels
    std::string way;
    std::vector<CardTime> places; ///< by place
    std::uint64_t hash = 0;       ///< of the plans' sizes
};

struct PictureSize {
    std::uint32_t width = 0, height = 0; ///< pixels
};

struct CardEffort {
    int warmUps = 10, repeats = 15; ///< frames of each way at each place
};

/// Draws every place by each way in each size, with GPU timestamps around each frame. Frames follow one another
/// without a pause, so that the card does not wait for the next frame's commands. Requires a current context.
/// Errors: Driver; the loader's; the renderer's.
[[nodiscard]] Result<std::vector<CardTimes>>
timeOnCard(gpu::Device& device, const dat::Archive& archive, const world::WorldFile& file,
           const std::vector<world::Place>& places, const std::vector<CardWay>& ways,
           const std::vector<PictureSize>& sizes, const CardEffort& effort = {});

} // namespace limen::bench
