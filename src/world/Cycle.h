#pragma once

#include "geometry/Vec.h"
#include "world/Index.h"

#include <array>
#include <cstdint>

// The repeated animations of bodies, as a World stores them: read from Animation (0x03) and MotionTable
// (0x09) records by world/assemble/Cycles.h, played by motion/PartPoses.h. docs/formats/effects_anim.md#playback.
namespace limen::world {

/// The motions that a body may have a cycle for.
enum class Gait : std::uint8_t { Stand, Walk, Run };
inline constexpr std::size_t kGaits = 3;

/// The pose of one part of a body in one frame: object space from part space, without the part's own scale.
struct PartFrame {
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    Vec3 origin{0.0};
    friend bool operator==(const PartFrame&, const PartFrame&) = default;
};

/// Frames played at one rate: `frameCount` times `partCount` of World::partFrames, in the order of their
/// record.
struct Stretch {
    std::uint32_t firstPartFrame = 0; ///< index of the first part in the first frame
    std::uint32_t partCount = 0;      ///< of each frame; further parts of a body keep their resting poses
    std::uint32_t frameCount = 0;     ///< at least one
    double rate = 0.0;                ///< frames a second; negative: backwards; 0: stays at its first frame
    friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// Stretches played one after another. The last one repeats without end.
struct Cycle {
    std::uint32_t firstStretch = 0, stretchCount = 0; ///< run of World::stretches; at least one
    /// The body's velocity while the cycle plays at its own rate, metres a second in the body's frame. Zero:
    /// unknown.
    Vec3 velocity{0.0};
    friend bool operator==(const Cycle&, const Cycle&) = default;
};

/// The Setup's part that a moving part shows (several levels of detail may show the same one), and its scale.
struct PosedPart {
    std::uint32_t part = 0; ///< index in the Setup, and so in each frame
    Vec3 scale{1.0};
    bool isHeld = false; ///< a part of a thing that the Setup's part holds, at `grip` in its frame
    PartFrame grip{};
    friend bool operator==(const PosedPart&, const PosedPart&) = default;
};

/// The pose of a moving part in a frame of the Setup's part that it shows, or that holds it.
[[nodiscard]] inline PartFrame posedAt(const PartFrame& frame, const PosedPart& posed) {
    if (!posed.isHeld)
        return frame;
    return {frame.orientation * posed.grip.orientation, frame.origin + frame.orientation * posed.grip.origin};
}

/// The index, within its stretch, of the frame that is played at `step`; both 0..frameCount-1.
[[nodiscard]] constexpr std::uint32_t frameAt(const Stretch& stretch, std::uint32_t step) {
    return stretch.rate < 0.0 ? stretch.frameCount - 1 - step : step;
}

/// The frame that is played after step `step` of a cycle's stretch number `stretch`.
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
