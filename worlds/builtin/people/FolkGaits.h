#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

// A person's build, metres: hips, and where heel and toe of a foot are ahead of the hip, all in the leg's plane.
inline constexpr double kHip = 0.88, kHeel = -0.09, kToe = 0.17;
inline constexpr double kWheelRadius = 0.555; ///< of a cart
inline constexpr int kSpokes = 8;             ///< of a wheel, which looks the same after each

/// How a part of a person goes along.
enum class Role { Body, Head, LeftArm, RightArm, LeftLeg, RightLeg, Held, Wheel };

/// One way of going forward.
struct Stride {
    double length = 1.0;   ///< metres for a step of each leg
    int frames = 30;       ///< likewise, at 30 a second
    double grounded = 0.6; ///< share of that for which a foot is on the ground; less than half: running
    double lift = 0.04;    ///< metres that a foot is carried over the ground
    double bob = -0.03;    ///< metres that the body rises from foot to foot; negative: it sinks
    double arms = 0.4;     ///< radians that they swing each way
    double lean = 0.03;    ///< radians forward
    double twist = 0.06;   ///< radians that the shoulders turn each way
};

/// The two ways in which people go.
struct Strides {
    Stride walk, run;
};
/// With long steps. Lengths roll a wheel by whole spokes.
[[nodiscard]] Strides longStrides();
/// With short ones, as a gown or an apron allows.
[[nodiscard]] Strides shortStrides();

/// Writes what people made of these parts do, standing, walking and running, and yields the motion table's id. Feet on the ground
/// stay where they are. `roles`: one a part; `dust`: ParticleEmitter that is started where a foot is set down; what is held stays as the Setup has it, and so does an arm that holds.
[[nodiscard]] dat::RecordId addGaits(ModelWriter& sink, const std::vector<SetupPart>& parts,
                                     const std::vector<Role>& roles, const Strides& strides,
                                     dat::RecordId dust = 0);

} // namespace limen::worlds
