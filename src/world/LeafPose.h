#pragma once

#include "world/World.h"

// Poses of door leaves: about a hinge, or along the keys of a motion table.
namespace limen::world {

/// Global space from the leaf's own space, without its scale.
struct LeafPose {
    Mat3 turn{1.0};
    Vec3 origin{0.0};
};

/// The pose of a leaf at an openness 0..1. Between keys it moves and turns at a constant rate.
[[nodiscard]] LeafPose leafPose(const World& world, const Leaf& leaf, double open);

/// True if the leaf has different poses shut and open.
[[nodiscard]] bool canMove(const World& world, const Leaf& leaf);

/// A global sphere around the leaf at every openness.
[[nodiscard]] Sphere leafReach(const World& world, const Leaf& leaf);

/// Metres that the farthest point of the leaf moves in a full swing, at least.
[[nodiscard]] double leafWay(const World& world, const Leaf& leaf);

} // namespace limen::world
