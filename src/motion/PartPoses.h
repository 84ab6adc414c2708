#pragma once

#include "world/World.h"

#include <optional>

// How a body's parts stand while it stands still, walks or runs: playback of the cycles in a World (world/Cycle.h), after
// docs/formats/effects_anim.md#playback. Pure functions that allocate nothing.
namespace limen::motion {

/// What a body does at a moment: the cycle that it plays, and how far into it.
struct CyclePoint {
    std::uint32_t cycle = world::kNone; ///< index into World::cycles; kNone: the body rests
    double seconds = 0.0;               ///< since its first frame, at its own rate; may be negative
};

/// What a body goes at: stands at `speed` 0, else walks or runs, whichever of its cycles' velocities is nearer. Speed in metres a
/// second, of either sign; a body whose cycles say no velocities walks.
[[nodiscard]] world::Gait gaitAt(const world::World& world, const world::MovingBody& body, double speed);

/// Where a body is in what it does. A cycle for going forward that says its velocity follows the `metres` gone, so that feet
/// stay where they are set down, at any speed and whatever changes it; every other one follows the `seconds`. Both since whenever
/// the caller counts from; metres may shrink (backwards) and either may be negative. A body without the cycle asked for runs as
/// it walks, walks as it runs, and else does as it stands, by the seconds; without any it rests.
[[nodiscard]] CyclePoint cyclePoint(const world::World& world, const world::MovingBody& body,
                                    world::Gait gait, double metres, double seconds);

/// Where a part stands: the body's own space from part space.
struct PartPose {
    Mat3 linear{1.0};
    Vec3 origin{0.0};
};

/// All parts of one body at one moment. Between two frames they turn and move evenly from one to the other
/// (docs/uncertain.md); parts that the frames do not have stand as they rest. World and body must outlive it.
class PartPoses {
public:
    PartPoses(const world::World& world, const world::MovingBody& body, const CyclePoint& at);

    /// Of the body's `index`-th part, 0..partCount-1.
    [[nodiscard]] PartPose of(std::uint32_t index) const;
    /// The frame of a part of its Setup, whether it shows anything or not; nothing if that stands as it rests.
    [[nodiscard]] std::optional<world::PartFrame> frameOf(std::uint32_t part) const;

private:
    [[nodiscard]] const world::PartFrame* frame(const world::Stretch& stretch, std::uint32_t step,
                                                std::uint32_t part) const;

    const world::World& world_;
    const world::MovingBody& body_;
    const world::Stretch* stretch_ = nullptr; ///< of the frame that was played last; null: the body rests
    const world::Stretch* then_ = nullptr;    ///< of the one that follows
    std::uint32_t step_ = 0, thenStep_ = 0;
    double between_ = 0.0; ///< 0 at the one .. 1 at the other
};

} // namespace limen::motion
