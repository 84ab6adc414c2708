#include "worlds/builtin/people/FolkGaits.h"

#include "geometry/Angles.h"
#include "worlds/builtin/effects/Effects.h"
#include "worlds/builtin/people/MotionCommands.h"

#include <algorithm>
#include <numbers>

namespace limen::worlds {

namespace {

constexpr double kRate = 30.0; ///< frames a second of walking and running
constexpr double kStandingRate = 8.0;
constexpr int kStandingFrames = 48;

Quat about(const Vec3& axis, double angle) {
    return glm::angleAxis(angle, axis);
}
constexpr Vec3 kAcross{1, 0, 0}, kAhead{0, 1, 0}, kUp{0, 0, 1};

/// A pose of a leg: turned forward about the hip by `angle` (radians), with the hip at height `hip` (metres).
struct Leg {
    double angle = 0.0, hip = kHip;
};

/// The angle of a leg whose sole touches the ground at a point that is `ahead` of the hip in the standing
/// pose, after the hip has moved `gone` metres forward. 0 for `gone` = 0, for heel and toe alike.
double angleFor(double ahead, double gone) {
    return std::asin((ahead - gone) / std::hypot(kHip, ahead)) - std::atan2(ahead, kHip);
}
/// The angle of a leg on the ground: the foot rolls over its heel while it is ahead of the hip, then over its
/// toe.
double groundedAngle(double gone) {
    return angleFor(gone < 0.0 ? kHeel : kToe, gone);
}
/// The height of the hip at which heel and toe are not below the ground.
double hipAbove(double angle) {
    const double lower = std::min(kHeel * std::sin(angle), kToe * std::sin(angle));
    return kHip * std::cos(angle) - lower;
}

/// Cubic Hermite interpolation from `a` to `b` for u in 0..1, with these slopes at both ends.
double smooth(double u, double a, double b, double leaving, double arriving) {
    const double u2 = u * u, u3 = u2 * u;
    return a * (2 * u3 - 3 * u2 + 1) + b * (3 * u2 - 2 * u3) + leaving * (u3 - 2 * u2 + u) +
           arriving * (u3 - u2);
}

/// The pose of a leg at `phase` (0..1) of its stride, which begins when the heel touches the ground.
Leg legAt(const Stride& stride, double phase) {
    const double onGround = stride.length * stride.grounded;
    if (phase < stride.grounded) {
        const double angle = groundedAngle(stride.length * phase - onGround / 2.0);
        return {angle, hipAbove(angle)};
    }
    const double share = 1.0 - stride.grounded;
    const double u = (phase - stride.grounded) / share;
    constexpr double kStep = 1e-4; // metres
    const auto slopeAt = [&](double gone, double step) {
        return (groundedAngle(gone + step) - groundedAngle(gone)) / step * stride.length * share;
    };
    const double angle = smooth(u, groundedAngle(onGround / 2.0), groundedAngle(-onGround / 2.0),
                                slopeAt(onGround / 2.0, -kStep), slopeAt(-onGround / 2.0, kStep));
    return {angle, hipAbove(angle) + stride.lift * std::sin(u * kTurn / 2.0)};
}

/// The pose of a whole person.
struct Posture {
    Quat body{1.0, 0.0, 0.0, 0.0}; ///< about the middle of the hips
    double rise = 0.0;
    Quat head{1.0, 0.0, 0.0, 0.0};
    double leftArm = 0.0, rightArm = 0.0; ///< forward from hanging down; radians
    Leg left, right;
    double rolled = 0.0; ///< turn of wheels, radians
};

double partOf(double phase) {
    return phase - std::floor(phase);
}

/// The pose at `phase` strides after the left heel first touched the ground.
Posture going(const Stride& stride, double phase) {
    Posture p;
    const double swing = std::cos(kTurn * phase);
    const double middle = 2.0 * kTurn * (phase - stride.grounded / 2.0); // radians of a stride
    p.body = about(kUp, stride.twist * swing) * about(kAcross, -stride.lean);
    p.rise = stride.bob * (1.0 - std::cos(middle)) / 2.0;
    p.head = about(kAcross, -stride.lean / 2.0);
    p.leftArm = -stride.arms * swing;
    p.rightArm = stride.arms * swing;
    p.left = legAt(stride, partOf(phase));
    p.right = legAt(stride, partOf(phase + 0.5));
    p.rolled = -stride.length * phase / kWheelRadius;
    return p;
}

/// The standing pose at `phase` of a cycle, with two breaths and one sway.
Posture standing(double phase) {
    Posture p;
    const double sway = std::sin(kTurn * phase), breath = std::sin(2.0 * kTurn * phase);
    p.body = about(kAhead, 0.012 * sway) * about(kAcross, 0.008 * breath);
    p.rise = 0.003 * breath;
    p.head = about(kUp, 0.09 * std::sin(kTurn * (phase + 0.15))) * about(kAcross, -0.02 - 0.02 * breath);
    p.leftArm = 0.02 + 0.03 * breath;
    p.rightArm = 0.02 + 0.03 * std::sin(2.0 * kTurn * (phase + 0.06));
    return p;
}

dat::Frame frameOf(const Vec3& origin, const Quat& orientation) {
    return {Vec3f(origin), Quatf(orientation)};
}

dat::Frame frameOf(const Posture& p, const SetupPart& part, Role role) {
    const Vec3 rest = part.at.origin;
    const Vec3 hips{0.0, 0.0, kHip};
    const Vec3 carried = hips + p.body * (rest - hips) + kUp * p.rise;
    switch (role) {
    case Role::Body:
        return frameOf(carried, p.body);
    case Role::Head:
        return frameOf(carried, p.head);
    case Role::LeftArm:
        return frameOf(carried, about(kAcross, p.leftArm));
    case Role::RightArm:
        return frameOf(carried, about(kAcross, p.rightArm));
    case Role::LeftLeg:
        return frameOf({rest.x, rest.y, p.left.hip}, about(kAcross, p.left.angle));
    case Role::RightLeg:
        return frameOf({rest.x, rest.y, p.right.hip}, about(kAcross, p.right.angle));
    case Role::Wheel:
        return frameOf(rest, about(kAcross, p.rolled));
    case Role::Held:
        break;
    }
    return toFrame(part.at);
}

dat::AnimationFrame frameOf(const Posture& p, const std::vector<SetupPart>& parts,
                            const std::vector<Role>& roles) {
    dat::AnimationFrame frame;
    for (std::size_t k = 0; k < parts.size(); ++k)
        frame.parts.push_back(frameOf(p, parts[k], roles[k]));
    return frame;
}

dat::MotionData played(dat::RecordId animation, double rate, double velocity) {
    dat::MotionData data;
    data.animations = {{animation, 0, -1, static_cast<float>(rate)}};
    data.flags = velocity > 0.0 ? dat::MotionData::kVelocity : std::uint8_t{0};
    data.velocity = Vec3f(0.0f, static_cast<float>(velocity), 0.0f);
    return data;
}

dat::MotionData addGoing(ModelWriter& writer, const std::vector<SetupPart>& parts,
                         const std::vector<Role>& roles, const Stride& stride, dat::RecordId dust) {
    // The cycle has whole turns of a wheel, so that it ends in its first pose.
    const int rounds = std::count(roles.begin(), roles.end(), Role::Wheel) > 0 ? kSpokes : 1;
    std::vector<dat::AnimationFrame> frames;
    for (int k = 0; k < rounds * stride.frames; ++k)
        frames.push_back(frameOf(going(stride, static_cast<double>(k) / stride.frames), parts, roles));
    for (std::size_t part = 0; part < parts.size() && dust != 0; ++part) {
        // A hook is played when its frame ends.
        const auto frame = [&](double phase) { return static_cast<std::size_t>(phase * stride.frames); };
        if (roles[part] == Role::LeftLeg || roles[part] == Role::RightLeg) {
            frames[frame(roles[part] == Role::LeftLeg ? 0.0 : 0.5)].hooks.push_back(
                particleHook(dust, static_cast<int>(part), {0.0, kHeel, 0.02 - kHip}));
        }
    }
    return played(writer.addAnimation(std::move(frames)), kRate, stride.length * kRate / stride.frames);
}

} // namespace

Strides longStrides() {
    constexpr double kSpoke = kTurn * kWheelRadius / kSpokes;
    return {{.length = 3.0 * kSpoke, .frames = 30},
            {.length = 5.0 * kSpoke,
             .frames = 21,
             .grounded = 0.38,
             .lift = 0.09,
             .bob = 0.05,
             .arms = 0.7,
             .lean = 0.14,
             .twist = 0.10}};
}

Strides shortStrides() {
    return {{.length = 0.8, .frames = 22, .lift = 0.03, .bob = -0.015, .arms = 0.2, .twist = 0.04},
            {.length = 1.1,
             .frames = 15,
             .grounded = 0.4,
             .lift = 0.05,
             .bob = 0.03,
             .arms = 0.35,
             .lean = 0.08,
             .twist = 0.06}};
}

dat::RecordId addGaits(ModelWriter& writer, const std::vector<SetupPart>& parts,
                       const std::vector<Role>& roles, const Strides& strides, dat::RecordId dust) {
    std::vector<dat::AnimationFrame> still;
    for (int k = 0; k < kStandingFrames; ++k)
        still.push_back(frameOf(standing(static_cast<double>(k) / kStandingFrames), parts, roles));
    dat::MotionTable table;
    table.defaultStyle = kNonCombat;
    table.styleDefaults = {{kNonCombat, kReady}};
    table.cycles = {
        {dat::motionKey(kNonCombat, kReady),
         played(writer.addAnimation(std::move(still)), kStandingRate, 0.0)},
        {dat::motionKey(kNonCombat, kWalkForward), addGoing(writer, parts, roles, strides.walk, dust)},
        {dat::motionKey(kNonCombat, kRunForward), addGoing(writer, parts, roles, strides.run, dust)}};
    return writer.addMotionTable(std::move(table));
}

} // namespace limen::worlds
