#include "motion/ChaseCamera.h"

#include "core/Assert.h"
#include "motion/Locate.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

constexpr double kBesideSphere = 0.005; // metres kept beside the sphere: two sweeps of one way differ by less
constexpr double kUnit = 1e-6;          // the square of a unit vector's length is off 1 by less

/// A sphere that is swept from obstacle to obstacle.
class SweptSphere {
public:
    SweptSphere(double radius, const Standing& start, const Collisions& around, std::span<const double> doors)
        : shape_{radius, 2.0 * radius}, at_(start), around_(around), doors_(doors) {}

    /// The free part of a straight way along a unit vector; metres, at most `most`.
    [[nodiscard]] double freeAlong(const Vec3& direction, double most) const {
        const std::optional<Bump> bump =
            around_.sweep(shape_, at_, at_.feet + direction * (most + kBesideSphere), doors_);
        return bump ? std::clamp(bump->share * (most + kBesideSphere) - kBesideSphere, 0.0, most) : most;
    }

    void go(const Vec3& way) {
        const Vec3 from = middle();
        at_.space = sweep(around_.world(), at_.space, from, from + way);
        at_.feet += way;
    }

    [[nodiscard]] Vec3 middle() const { return shape_.middle(at_.feet); }
    [[nodiscard]] world::SpaceIndex space() const { return at_.space; }

private:
    Capsule shape_;
    Standing at_;
    const Collisions& around_;
    std::span<const double> doors_;
};

/// A length `seconds` later: it shrinks to the free length at once, and grows towards it exponentially.
double lengthAfter(double length, double free, double seconds, const ChaseShape& shape) {
    if (length >= free)
        return free;
    length = free - (free - length) * std::exp(-shape.quick * std::max(seconds, 0.0));
    return free - length < shape.still ? free : length;
}

} // namespace

ChaseState chased(const ChaseState& before, const BodyState& body, const Vec3& forward, double seconds,
                  const Collisions& around, std::span<const double> doors, double headRise,
                  const BodyShape& bodyShape, const ChaseShape& shape) {
    LIMEN_ASSERT(std::abs(glm::dot(forward, forward) - 1.0) < kUnit, "the gaze is a unit vector");
    LIMEN_ASSERT(std::isfinite(seconds), "the camera moves for a finite time");
    const Vec3 up(0.0, 0.0, 1.0);
    const Capsule& capsule = bodyShape.capsule;
    const double radius = std::min(shape.radius, capsule.radius);
    const Vec3 middle = capsule.middle(body.standing.feet);
    SweptSphere sphere(radius, {middle - up * radius, body.standing.space}, around, doors);
    const double head = bodyShape.eyeHeight - 0.5 * capsule.height + headRise;
    sphere.go(up * std::copysign(sphere.freeAlong(up * std::copysign(1.0, head), std::abs(head)), head));
    ChaseState now;
    now.arm = lengthAfter(before.arm, sphere.freeAlong(-forward, shape.distance), seconds, shape);
    sphere.go(-forward * now.arm);
    now.lift = lengthAfter(before.lift, sphere.freeAlong(up, shape.rise), seconds, shape);
    sphere.go(up * now.lift);
    now.eye = {sphere.middle(), sphere.space()};
    return now;
}

} // namespace limen::motion
