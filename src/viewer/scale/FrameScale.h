#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace limen::viewer {

/// Limits of the scale, per cent of the window's pixels each way.
struct ScaleBounds {
    std::uint32_t least = 50, most = 100;
    friend bool operator==(const ScaleBounds&, const ScaleBounds&) = default;
};

/// Measured times of one frame, milliseconds.
struct FrameTimes {
    double scene = 0.0; ///< of the 3-D picture, which depends on its size
    double other = 0.0; ///< of all else in the frame
};

/// The aim of the control, and its limits.
struct ScaleGoal {
    double frameMs = 1e3 / 30.0; ///< the longest frame, milliseconds
    ScaleBounds bounds{};
    std::uint32_t settling = 1; ///< frames after a change whose times are not yet those of the new size
};

/// Chooses the scale of the 3-D picture so that frames keep a rate. Decides by the times alone: the same times
/// give the same scales.
///
/// Frames that are too long lower the scale, in a few frames. It rises only if a larger picture would still be
/// a tenth below the goal, even if all work grew with the pixels. Between the two, it stays. A rise that must be
/// taken back doubles the wait before the next one (docs/decisions/0145-scale-by-measured-frames.md).
class FrameScale {
public:
    static constexpr std::uint32_t kStep = 5;

    /// Takes the times of one more frame at `percent()`. Returns the scale of the next frame.
    std::uint32_t next(const FrameTimes& times, const ScaleGoal& goal);
    [[nodiscard]] std::uint32_t percent() const { return percent_; }
    /// Brings the scale into the bounds.
    void confine(const ScaleBounds& bounds);
    /// Sets the scale, and forgets all times.
    void set(std::uint32_t percent);

private:
    static constexpr std::size_t kKept = 30; ///< frames that decide about a rise

    void add(const FrameTimes& times);
    /// The median of the last `count` frames, scene and other apart. Requires that many.
    [[nodiscard]] FrameTimes median(std::size_t count) const;
    [[nodiscard]] bool isTooLong(const ScaleGoal& goal) const;
    void lower(const ScaleGoal& goal);
    void rise(const ScaleGoal& goal);
    void change(std::uint32_t percent);

    std::uint32_t percent_ = 100;
    std::array<FrameTimes, kKept> times_{}; ///< at the current scale, as a ring
    std::size_t count_ = 0;                 ///< frames at the current scale
    std::uint32_t skipped_ = 0;             ///< frames since the change that were left out
    std::size_t wait_ = kKept;              ///< frames before the next rise
    bool hasRisen_ = false;                 ///< the last change was a rise
};

} // namespace limen::viewer
