#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

namespace limen::test {

/// Mechanisms that live in the loaded data and not in the drawing: tests leave one out of what is drawn, while the
/// reference keeps the whole (docs/proof.md).
struct Omissions {
    bool membership = false; ///< objects are members of no space but the one they are placed in
    bool fillings = false;   ///< shut openings are drawn open, without what fills them
};

/// The world with every instance a member of the space it is placed in, alone.
[[nodiscard]] world::World withoutMembership(const world::World& world);

/// The moment less what is omitted; instances keep their numbers. `world` is the one that it is a moment of.
[[nodiscard]] world::DynamicState without(const Omissions& omissions, const world::World& world,
                                          const world::DynamicState& dynamics);

} // namespace limen::test
