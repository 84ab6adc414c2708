#pragma once

#include "engine/Camera.h"
#include "world/Places.h"

#include <span>
#include <vector>

namespace limen::play {

/// A camera path through way points: straight lines at walking speed. The camera turns on the way and moves
/// slower where the turn needs more time than the distance. Before a jump (world::isJump) it
/// rests.
class CameraPath {
public:
    static constexpr double kWalkingSpeed = 3.0;  ///< metres a second
    static constexpr double kTurningSpeed = 70.0; ///< degrees a second
    static constexpr double kRecordedStep = 0.12; ///< seconds
    static constexpr double kJumpSeconds = 1.0;   ///< of rest before a jump

    /// Requires finite way points. No way point gives an empty path, one way point a path of zero length.
    explicit CameraPath(std::span<const world::Place> wayPoints);

    [[nodiscard]] bool empty() const { return wayPoints_.empty(); }
    [[nodiscard]] double seconds() const { return empty() ? 0.0 : times_.back(); }
    /// Eye and heading at a time, clamped to the path's ends. Requires a path that is not empty.
    [[nodiscard]] engine::Camera at(double time) const;
    /// A way point between two times.
    struct Corner {
        Vec3 eye{0.0};
        dat::RecordId cell = 0; ///< that a jump leads to; 0: the outside
        bool isJump = false;    ///< the camera is put here, and not moved
    };
    /// The way points strictly between two times, in order, and a jump at `to`. A straight sweep between the
    /// times would cut these corners.
    void cornersBetween(double from, double to, std::vector<Corner>& out) const;
    /// The time of frame `frame` of `count`, spread evenly from start to end.
    [[nodiscard]] double timeOfFrame(std::size_t frame, std::size_t count) const;

private:
    /// True if the camera is put at this way point, and not moved to it.
    [[nodiscard]] bool isJumpTo(std::size_t point) const;

    std::vector<world::Place> wayPoints_;
    std::vector<double> times_; ///< the arrival time at each way point, seconds
};

/// The difference b - a of two angles in degrees, wrapped to -180..180.
[[nodiscard]] double shortTurn(double a, double b);

} // namespace limen::play
