#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

// A person's measures, metres: height of the hip; heel and toe relative to the hip, forwards. All in the
// leg's plane.
inline constexpr double kHip = 0.88, kHeel = -0.09, kToe = 0.17;
inline constexpr double kWheelRadius = 0.555; ///< of a cart, metres
inline constexpr int kSpokes = 8;             ///< of a wheel, which looks the same after a turn by one spoke

/// The motion of a part of a person.
enum class Role { Body, Head, LeftArm, RightArm, LeftLeg, RightLeg, Held, Wheel };

/// The parameters of a walk or run.
struct Stride {
    double length = 1.0;   ///< metres of a stride: one step of each leg
    int frames = 30;       ///< frames of a stride, 30 a second
    double grounded = 0.6; ///< share of a stride for which a foot is on the ground; running: less than half
    double lift = 0.04;    ///< height of a moving foot above the ground, metres
    double bob = -0.03;    ///< rise of the body between steps, metres; negative: it sinks
    double arms = 0.4;     ///< amplitude of the arms, radians
    double lean = 0.03;    ///< forward lean, radians
    double twist = 0.06;   ///< amplitude of the shoulders, radians
};

struct Strides {
    Stride walk, run;
};
/// Long steps. Their lengths turn a wheel by whole spokes.
[[nodiscard]] Strides longStrides();
/// Short steps, for people in a gown or an apron.
[[nodiscard]] Strides shortStrides();

/// Adds a MotionTable and Animations for standing, walking and running; returns the table's id. Feet on the
/// ground do not slide. `roles`: one for each part; a held object and the arm that holds it keep the pose of
/// the Setup. `dust`: a ParticleEmitter to start at each footfall, or 0.
[[nodiscard]] dat::RecordId addGaits(ModelWriter& writer, const std::vector<SetupPart>& parts,
                                     const std::vector<Role>& roles, const Strides& strides,
                                     dat::RecordId dust = 0);

} // namespace limen::worlds
