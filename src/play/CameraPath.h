#pragma once

#include "engine/Camera.h"
#include "world/Places.h"

#include <span>
#include <vector>

namespace limen::play {

/// A camera path through way points: straight lines at walking speed. The camera turns on the way and moves
/// slower where the turn needs more time than the distance.
class CameraPath {
public:
    static constexpr double kWalkingSpeed = 3.0;  ///< metres a second
    static constexpr double kTurningSpeed = 70.0; ///< degrees a second
    static constexpr double kRecordedStep = 0.12; ///< seconds

    /// Requires finite way points. No way point gives an empty path, one way point a path of zero length.
    explicit CameraPath(std::span<const world::Place> wayPoints);

    [[nodiscard]] bool empty() const { return wayPoints_.empty(); }
    [[nodiscard]] double seconds() const { return empty() ? 0.0 : times_.back(); }
    /// Eye and heading at a time, clamped to the path's ends. Requires a path that is not empty.
    [[nodiscard]] engine::Camera at(double time) const;
    /// The way points strictly between two times, in order. A straight sweep between the times would cut
    /// these corners.
    void cornersBetween(double from, double to, std::vector<Vec3>& out) const;
    /// The time of frame `frame` of `count`, spread evenly from start to end.
    [[nodiscard]] double timeOfFrame(std::size_t frame, std::size_t count) const;

private:
    std::vector<world::Place> wayPoints_;
    std::vector<double> times_; ///< the arrival time at each way point, seconds
};

/// The difference b - a of two angles in degrees, wrapped to -180..180.
[[nodiscard]] double shortTurn(double a, double b);

} // namespace limen::play
