#include "motion/ChaseCamera.h"

#include "motion/Locate.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

constexpr double kBesideSphere = 0.005; // metres beside the ball: two sweeps of one way differ by less

/// A ball that goes where nothing is in its way.
class Sphere_ {
public:
    Sphere_(double radius, const Standing& start, const Collisions& around, std::span<const double> doors)
        : shape_{radius, 2.0 * radius}, at_(start), around_(around), doors_(doors) {}

    /// Metres of a straight way, along a unit vector, that are free, of at most so many.
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

/// What was so long, and may be as long as is free: shorter at once, longer by and by.
double after(double length, double free, double seconds, const ChaseShape& shape) {
    if (length >= free)
        return free;
    length = free - (free - length) * std::exp(-shape.quick * std::max(seconds, 0.0));
    return free - length < shape.still ? free : length;
}

} // namespace

ChaseState chased(const ChaseState& before, const BodyState& body, const Vec3& forward, double seconds,
                  const Collisions& around, std::span<const double> doors, double headRise,
                  const BodyShape& bodyShape, const ChaseShape& shape) {
    const Vec3 up(0.0, 0.0, 1.0);
    const Capsule& capsule = bodyShape.capsule;
    const double radius = std::min(shape.radius, capsule.radius);
    const Vec3 middle = capsule.middle(body.standing.feet);
    Sphere_ sphere(radius, {middle - up * radius, body.standing.space}, around, doors);
    const double head = bodyShape.eyeHeight - 0.5 * capsule.height + headRise;
    sphere.go(up * std::copysign(sphere.freeAlong(up * std::copysign(1.0, head), std::abs(head)), head));
    ChaseState now;
    now.arm = after(before.arm, sphere.freeAlong(-forward, shape.distance), seconds, shape);
    sphere.go(-forward * now.arm);
    now.lift = after(before.lift, sphere.freeAlong(up, shape.rise), seconds, shape);
    sphere.go(up * now.lift);
    now.eye = {sphere.middle(), sphere.space()};
    return now;
}

} // namespace limen::motion
