#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

namespace limen::test {

/// Mechanisms in the loaded data rather than in the drawing. Tests omit one from the drawn world, while the
/// reference keeps all (docs/proof.md).
struct Omissions {
    bool membership = false; ///< objects are members only of the space they are placed in
    bool fillings = false;   ///< closed openings are drawn open, without their fillings
};

/// The world with every instance a member only of the space it is placed in.
[[nodiscard]] world::World withoutMembership(const world::World& world);

/// The dynamic state without the omitted part; instances keep their numbers. `world` is its world.
[[nodiscard]] world::DynamicState without(const Omissions& omissions, const world::World& world,
                                          const world::DynamicState& dynamics);

} // namespace limen::test
