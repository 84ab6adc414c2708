#include "motion/Body.h"

#include "core/Assert.h"
#include "core/SmallVec.h"
#include "geometry/Compass.h"
#include "motion/Locate.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

constexpr double kLongestStep = 0.017; // seconds: whole steps at 30 and 60 frames a second
constexpr double kSkin = 0.005;        // metres kept between a body and its obstacles
constexpr int kMostSlides = 4;         // planes that one step slides along
constexpr int kMostWaysOut = 4;        // attempts to leave overlaps
constexpr int kLifts = 4; // heights from which a step is tried: round feet slide over the rest of 0.15 m
constexpr double kFlattest = 0.05;   // least upward part of the normal of an edge that carries a body
constexpr double kBehindEdge = 0.02; // metres: where the surface behind an edge is probed
constexpr double kAboveEdge =
    0.05;                       // metres above the edge where the probe begins, and below it where it ends
constexpr double kStill = 1e-4; // metres: settling by less leaves a standing body as it is, to the bit
constexpr double kHeld = 0.01;  // share of its way that a falling body moves at most while it is wedged
constexpr double kDeepestFall = 100.0; // metres below the last safe position: the body fell out of the world
constexpr double kNoLength = 1e-6;     // metres, or parts of a unit normal: shorter vectors have no direction

const Vec3 kUp(0.0, 0.0, 1.0);

/// One step of a body.
class Step {
public:
    Step(const BodyState& body, const Collisions& around, std::span<const double> doors,
         const BodyShape& shape)
        : body_(body), around_(around), doors_(doors), shape_(shape) {}

    [[nodiscard]] BodyState take(const BodyInput& input, double seconds, bool isFirst) {
        if (isFirst) // doors may have moved since; the body's own steps cause no overlap
            leaveOverlaps();
        steer(input, seconds);
        if (body_.isOnGround)
            walk(Vec3(body_.velocity.x, body_.velocity.y, 0.0) * seconds);
        else
            fly(body_.velocity * seconds);
        if (body_.isOnGround)
            body_.safe = body_.standing;
        if (!isFinite(body_.standing.feet) || body_.standing.feet.z < body_.safe.feet.z - kDeepestFall)
            recover();
        return body_;
    }

    [[nodiscard]] BodyState giveWay(const Vec3& way) {
        if (body_.isOnGround)
            walk(way);
        else
            slide(way, true);
        return body_;
    }

private:
    [[nodiscard]] bool isGround(const Vec3& normal) const { return normal.z >= shape_.steepest; }

    /// Round feet touch the edge of a step at a slant. There the surface behind the edge decides.
    [[nodiscard]] bool isGround(const Bump& bump) const {
        if (isGround(bump.normal))
            return true;
        const Vec3 beyond(-bump.normal.x, -bump.normal.y, 0.0);
        const double level = glm::length(beyond);
        if (bump.normal.z < kFlattest || level < kNoLength)
            return false;
        const Vec3 above = bump.at + beyond * (kBehindEdge / level) + kUp * kAboveEdge;
        const std::optional<Vec3> surface =
            around_.surfaceBelow(shape_.capsule, body_.standing, above, 2.0 * kAboveEdge, doors_);
        return surface && isGround(*surface);
    }

    /// Moves in a straight line through any obstacle, and tracks the space.
    void goTo(const Vec3& feet) {
        Standing& here = body_.standing;
        here.space =
            sweep(around_.world(), here.space, shape_.capsule.middle(here.feet), shape_.capsule.middle(feet));
        here.feet = feet;
    }

    /// Moves in a straight line until the skin reaches an obstacle.
    std::optional<Bump> push(const Vec3& way) {
        const double length = glm::length(way);
        if (!(length > 0.0))
            return std::nullopt;
        const Vec3 from = body_.standing.feet, direction = way / length;
        std::optional<Bump> bump =
            around_.sweep(shape_.capsule, body_.standing, from + direction * (length + kSkin), doors_);
        const double free = bump ? bump->share * (length + kSkin) - kSkin : length;
        if (free > 0.0)
            goTo(from + direction * std::min(free, length));
        if (bump)
            highest_ = std::max(highest_, bump->at.z);
        return bump;
    }

    /// Moves along `way`, and along each obstacle that is met. A surface too steep to stand on is a vertical
    /// wall to a walking body.
    void slide(Vec3 way, bool walks) {
        SmallVec<Vec3, kMostSlides> planes;
        for (int i = 0; i < kMostSlides && glm::length(way) > 1e-9; ++i) {
            const Vec3 before = body_.standing.feet;
            const std::optional<Bump> bump = push(way);
            if (!bump)
                return;
            way -= body_.standing.feet - before;
            Vec3 normal = bump->normal;
            if (walks && !isGround(normal)) {
                normal.z = 0.0;
                const double level = glm::length(normal);
                normal = level > kNoLength ? normal / level : Vec3(0.0);
            }
            planes.push_back(normal);
            way = along(way, {planes.begin(), planes.end()});
            landOn(*bump);
        }
    }

    /// The part of a way that leads into no plane: along one plane, else along the crease of two, else none.
    [[nodiscard]] static Vec3 along(const Vec3& way, std::span<const Vec3> planes) {
        const auto isFree = [&](const Vec3& w) {
            return std::all_of(planes.begin(), planes.end(),
                               [&](const Vec3& n) { return glm::dot(w, n) >= -1e-9; });
        };
        for (const Vec3& n : planes)
            if (const Vec3 left = way - n * glm::dot(way, n); isFree(left))
                return left;
        for (std::size_t i = 1; i < planes.size(); ++i) {
            const Vec3 crease = glm::cross(planes[i - 1], planes[i]);
            const double length = glm::dot(crease, crease);
            if (const Vec3 left = length > 1e-9 ? crease * (glm::dot(way, crease) / length) : Vec3(0.0);
                isFree(left))
                return left;
        }
        return Vec3(0.0);
    }

    void landOn(const Bump& bump) {
        Vec3& velocity = body_.velocity;
        const double into = glm::dot(velocity, bump.normal);
        if (into >= 0.0)
            return;
        if (velocity.z <= 0.0 && isGround(bump)) {
            body_.isOnGround = true;
            velocity.z = 0.0;
        } else {
            velocity -= bump.normal * into;
        }
    }

    void steer(const BodyInput& input, double seconds) {
        const Mat3 turn = turnedTo(input.yaw);
        Vec3 wish = turn * Vec3(input.right, input.forward, 0.0);
        const double length = glm::length(wish);
        wish *= (input.run ? shape_.runSpeed : shape_.walkSpeed) / std::max(length, 1.0);
        if (!body_.isOnGround) {
            body_.velocity.z -= shape_.gravity * seconds;
            return; // no ground to push against
        }
        body_.velocity = {wish.x, wish.y, 0.0};
        if (input.jump) {
            body_.velocity.z = shape_.jumpSpeed;
            body_.isOnGround = false;
        }
    }

    /// A body wedged between surfaces too steep to stand on counts as standing. In the air it could never
    /// steer free.
    void fly(const Vec3& way) {
        const Vec3 before = body_.standing.feet;
        const bool falls = way.z < 0.0;
        slide(way, false);
        const bool isHeld = glm::length(body_.standing.feet - before) < kHeld * glm::length(way);
        if (falls && isHeld && !body_.isOnGround) {
            body_.isOnGround = true;
            body_.velocity = Vec3(0.0);
        }
    }

    /// Moves on the level. If that is shorter than the way, tries again from the height of a step, and keeps
    /// the longer of the two. Both end on the ground. A low lintel stops a body that is lifted by a whole
    /// step, so smaller lifts follow. These must gain half of the way that is missing: else a body that leans
    /// on an upright obstacle, such as an open leaf, would climb its fittings by some centimetres.
    void walk(const Vec3& way) {
        const BodyState start = body_;
        slide(way, true);
        settle(shape_.stepDown);
        const double wanted = levelLength(way) - kNoLength;
        const double top = start.standing.feet.z + shape_.capsule.height;
        for (int lift = kLifts; lift > 0; --lift) {
            const double missing = wanted - levelLength(body_.standing.feet - start.standing.feet);
            if (missing <= 0.0)
                return;
            highest_ = top;
            stepOver(way, start, shape_.stepUp * lift / kLifts, lift == kLifts ? kNoLength : missing / 2.0);
            if (!(highest_ > top)) // the obstacle is no lintel
                return;
        }
    }

    /// Replaces a shorter way from `start` by the way from `lift` metres above it, if that ends farther away by
    /// more than `gain` metres.
    void stepOver(const Vec3& way, const BodyState& start, double lift, double gain) {
        const BodyState level = body_;
        body_ = start;
        push(kUp * lift);
        slide(way, true);
        settle(body_.standing.feet.z - start.standing.feet.z + shape_.stepDown);
        const bool isFarther = levelLength(body_.standing.feet - start.standing.feet) >
                               levelLength(level.standing.feet - start.standing.feet) + gain;
        const bool isTooHigh = touched_.z > start.standing.feet.z + shape_.stepUp + kSkin;
        if (!body_.isOnGround || !isFarther || isTooHigh)
            body_ = level;
    }

    /// Moves down to ground that is at most `deepest` metres below. Without such ground the body is in the
    /// air.
    void settle(double deepest) {
        const Standing before = body_.standing;
        const std::optional<Bump> bump = push(-kUp * deepest);
        body_.isOnGround = bump && isGround(*bump);
        touched_ = bump ? bump->at : before.feet;
        const bool isStill = glm::length(body_.standing.feet - before.feet) < kStill;
        if (!body_.isOnGround || isStill)
            body_.standing = before;
    }

    void leaveOverlaps() {
        for (int i = 0; i < kMostWaysOut; ++i) {
            const Vec3 out = around_.wayOut(shape_.capsule, body_.standing, doors_);
            if (glm::length(out) < kNoLength)
                return;
            goTo(body_.standing.feet + out);
        }
    }

    void recover() {
        body_.standing = body_.safe;
        body_.velocity = Vec3(0.0);
        body_.isOnGround = true;
        ++body_.recoveries;
    }

    [[nodiscard]] static double levelLength(const Vec3& v) { return std::hypot(v.x, v.y); }

    BodyState body_;
    Vec3 touched_{0.0};    ///< the point that the feet touched when they last settled; global
    double highest_ = 0.0; ///< the highest contact since it was set, global metres
    const Collisions& around_;
    std::span<const double> doors_;
    const BodyShape& shape_;
};

} // namespace

BodyState bodyAt(const Standing& standing) {
    BodyState body;
    body.standing = body.safe = standing;
    return body;
}

BodyState moved(const BodyState& body, const BodyInput& input, double seconds, const Collisions& around,
                std::span<const double> doors, const BodyShape& shape) {
    LIMEN_ASSERT(std::isfinite(seconds), "a body moves for a finite time");
    LIMEN_ASSERT(shape.capsule.height > 2.0 * shape.capsule.radius, "a capsule is higher than its two caps");
    BodyState now = body;
    const int steps = static_cast<int>(std::ceil(std::max(seconds, 0.0) / kLongestStep));
    for (int i = 0; i < steps; ++i)
        now = Step(now, around, doors, shape).take(input, seconds / steps, i == 0);
    return now;
}

BodyState shoved(const BodyState& body, const Vec3& way, const Collisions& around,
                 std::span<const double> doors, const BodyShape& shape) {
    LIMEN_ASSERT(isFinite(way), "a push has a finite length");
    return Step(body, around, doors, shape).giveWay(way);
}

BodyEye eyeOf(const BodyState& body, const world::World& world, const BodyShape& shape) {
    const Vec3 middle = shape.capsule.middle(body.standing.feet);
    const Vec3 eye = body.standing.feet + kUp * shape.eyeHeight;
    return {eye, sweep(world, body.standing.space, middle, eye)};
}

} // namespace limen::motion
