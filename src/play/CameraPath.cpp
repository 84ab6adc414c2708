#include "play/CameraPath.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::play {

namespace {

constexpr double kLongStretch = 1.0; ///< seconds

/// True for a closely sampled path. The spacing of its samples sets the pace.
bool isRecording(std::span<const world::Place> points) {
    constexpr std::size_t kFewest = 32;
    constexpr double kLongestStep = 1.05; // metres
    if (points.size() < kFewest)
        return false;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (!world::isJump(points[i - 1], points[i]) &&
            glm::length(points[i].eye - points[i - 1].eye) > kLongestStep)
            return false;
    return true;
}

double secondsBetween(const world::Place& from, const world::Place& to) {
    const double walk = glm::length(to.eye - from.eye) / CameraPath::kWalkingSpeed;
    const double turn = std::max(std::abs(shortTurn(from.yaw, to.yaw)), std::abs(to.pitch - from.pitch)) /
                        CameraPath::kTurningSpeed;
    return std::max(walk, turn);
}

} // namespace

double shortTurn(double a, double b) {
    return std::remainder(b - a, 360.0);
}

CameraPath::CameraPath(std::span<const world::Place> wayPoints)
    : wayPoints_(wayPoints.begin(), wayPoints.end()) {
    const bool recording = isRecording(wayPoints);
    double time = 0.0;
    for (std::size_t i = 0; i < wayPoints_.size(); ++i) {
        if (i > 0)
            time += isJumpTo(i) ? kJumpSeconds
                    : recording ? kRecordedStep
                                : secondsBetween(wayPoints_[i - 1], wayPoints_[i]);
        times_.push_back(time);
    }
}

engine::Camera CameraPath::at(double time) const {
    LIMEN_ASSERT(!empty(), "a position needs a path with way points");
    const double clamped = std::clamp(time, 0.0, seconds());
    const auto after = std::upper_bound(times_.begin(), times_.end(), clamped);
    const std::size_t last = wayPoints_.size() - 1;
    const std::size_t from =
        std::min<std::size_t>(static_cast<std::size_t>(after - times_.begin()) - 1, last);
    const std::size_t to = std::min(from + 1, last);
    const double span = times_[to] - times_[from];
    const double t = span > 0.0 && !isJumpTo(to) ? (clamped - times_[from]) / span : 0.0;
    // Between distant way points the turn eases in and out while the speed stays constant. Way points close
    // together form a curve already.
    const double turned = span > kLongStretch ? t * t * (3.0 - 2.0 * t) : t;
    engine::Camera camera;
    camera.eye = wayPoints_[from].eye + (wayPoints_[to].eye - wayPoints_[from].eye) * t;
    camera.heading.yaw = wayPoints_[from].yaw + shortTurn(wayPoints_[from].yaw, wayPoints_[to].yaw) * turned;
    camera.heading.pitch = wayPoints_[from].pitch + (wayPoints_[to].pitch - wayPoints_[from].pitch) * turned;
    return camera;
}

void CameraPath::cornersBetween(double from, double to, std::vector<Corner>& out) const {
    out.clear();
    for (std::size_t i = 0; i < times_.size(); ++i)
        if (times_[i] > from && (times_[i] < to || (times_[i] == to && isJumpTo(i))))
            out.push_back({wayPoints_[i].eye, wayPoints_[i].cell, isJumpTo(i)});
}

bool CameraPath::isJumpTo(std::size_t point) const {
    return point > 0 && world::isJump(wayPoints_[point - 1], wayPoints_[point]);
}

double CameraPath::timeOfFrame(std::size_t frame, std::size_t count) const {
    return count < 2 ? 0.0 : seconds() * static_cast<double>(frame) / static_cast<double>(count - 1);
}

} // namespace limen::play
