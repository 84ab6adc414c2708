#pragma once

#include "geometry/Vec.h"
#include "world/Index.h"

#include <array>
#include <cstdint>

// What bodies of several parts do over and over, as a World holds it: read from Animation (0x03) and MotionTable (0x09) records
// by world/Cycles.h, played by motion/PartPoses.h. After docs/formats/effects_anim.md#playback.
namespace limen::world {

/// What a body is at, as far as it has a cycle for it.
enum class Gait : std::uint8_t { Stand, Walk, Run };
inline constexpr std::size_t kGaits = 3;

/// Where one part of a body is in one frame: object space from part space, but for the part's own scale.
struct PartFrame {
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    Vec3 origin{0.0};
    friend bool operator==(const PartFrame&, const PartFrame&) = default;
};

/// Frames played at one rate: `frameCount` times `partCount` of World::partFrames, in the order of their record.
struct Stretch {
    std::uint32_t firstPartFrame = 0; ///< the first part's, in the first frame
    std::uint32_t partCount = 0;      ///< of each frame; of a body with more the others stay as they rest
    std::uint32_t frameCount = 0;     ///< at least one
    double rate = 0.0;                ///< frames a second; negative: backwards; 0: stays at its first frame
    friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// Stretches played one after another, of which the last goes on for ever.
struct Cycle {
    std::uint32_t firstStretch = 0, stretchCount = 0; ///< run of World::stretches; at least one
    /// Metres a second, in the body's own frame: how it goes forward while this is played at its own rate. Zero: not said.
    Vec3 velocity{0.0};
    friend bool operator==(const Cycle&, const Cycle&) = default;
};

/// Of a moving part: which part of its Setup it shows, perhaps one level of detail of several, and at which size.
struct PosedPart {
    std::uint32_t part = 0; ///< index in the Setup, and so in each frame
    Vec3 scale{1.0};
    friend bool operator==(const PosedPart&, const PosedPart&) = default;
};

/// The position in the record of the frame that is played as the `step`-th of a stretch, 0..frameCount-1.
[[nodiscard]] constexpr std::uint32_t frameAt(const Stretch& stretch, std::uint32_t step) {
    return stretch.rate < 0.0 ? stretch.frameCount - 1 - step : step;
}

/// The frame that is played after the `step`-th of a cycle's `stretch`-th stretch.
struct NextFrame {
    std::uint32_t stretch = 0, step = 0;
};
[[nodiscard]] constexpr NextFrame nextFrame(const Cycle& cycle, const Stretch& played, std::uint32_t stretch,
                                            std::uint32_t step) {
    if (step + 1 < played.frameCount)
        return {stretch, step + 1};
    return {stretch + 1 < cycle.stretchCount ? stretch + 1 : stretch, 0};
}

} // namespace limen::world
