#pragma once

#include "world/World.h"

#include <optional>

// Poses of a body's parts while the body stands, walks or runs: playback of the cycles in a World
// (world/Cycle.h), after docs/formats/effects_anim.md. Pure functions that allocate nothing.
namespace limen::motion {

/// A cycle and the time within it.
struct CyclePoint {
    std::uint32_t cycle = world::kNone; ///< index into World::cycles; kNone: the resting pose
    double seconds = 0.0;               ///< since the cycle's first frame, at its own rate; may be negative
};

/// The gait of a speed in metres a second, of either sign: standing at 0, else the gait whose cycle has the
/// nearer velocity. A body whose cycles have no velocities walks.
[[nodiscard]] world::Gait gaitAt(const world::World& world, const world::MovingBody& body, double speed);

/// The point of a body's cycle. Walk and run cycles with a velocity follow the `metres` walked, so feet do
/// not slide at any speed. All other cycles follow `seconds`. Both count from any origin that the caller
/// keeps; metres may decrease, and either may be negative. A missing walk or run cycle is replaced by the
/// other, then by standing, then by the resting pose.
[[nodiscard]] CyclePoint cyclePoint(const world::World& world, const world::MovingBody& body,
                                    world::Gait gait, double metres, double seconds);

/// The body's own space from part space.
struct PartPose {
    Mat3 linear{1.0};
    Vec3 origin{0.0};
};

/// The pose of a part between two frames of an animation.
enum class BetweenFrames : std::uint8_t {
    Held,        ///< that of the earlier frame, as in the original
    Interpolated ///< moves and turns at a constant rate, unless the part jumps
};

/// The poses of all parts of one body at one point of a cycle. A part jumps if it
/// moves more than 4 m, or turns more than 120 degrees, from one frame to the next; it is then never interpolated
/// (docs/retail.md). Parts that the frames lack have their resting pose. World and body must
/// outlive it.
class PartPoses {
public:
    PartPoses(const world::World& world, const world::MovingBody& body, const CyclePoint& at,
              BetweenFrames between);

    /// The pose of the body's `index`-th part, 0..partCount-1.
    [[nodiscard]] PartPose of(std::uint32_t index) const;
    /// The frame of a part of the body's Setup, drawn or not; none if the part has its resting pose.
    [[nodiscard]] std::optional<world::PartFrame> frameOf(std::uint32_t part) const;

private:
    [[nodiscard]] const world::PartFrame* frame(const world::Stretch& stretch, std::uint32_t step,
                                                std::uint32_t part) const;

    const world::World& world_;
    const world::MovingBody& body_;
    const world::Stretch* stretch_ = nullptr; ///< of the earlier frame; null: the resting pose
    const world::Stretch* then_ = nullptr;    ///< of the later frame
    std::uint32_t step_ = 0, thenStep_ = 0;   ///< of the two frames, within their stretches
    double between_ = 0.0; ///< 0 at the earlier frame .. 1 at the later one; 0 if it is held
};

} // namespace limen::motion
