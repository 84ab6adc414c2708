#pragma once

#include "worlds/builtin/dungeon/DungeonProps.h"
#include "worlds/shapes/Random.h"

#include <vector>

namespace limen::worlds {

/// Models of props. They stand on z = 0 around their origin unless the comment says otherwise.
struct Props {
    dat::RecordId crate = 0, pillar = 0;
    dat::RecordId screen = 0; ///< a cut-out lattice, 1.2 m along x
    dat::RecordId pane = 0;   ///< clear red glass, 1 × 1 m in the plane y = 0, around its origin
    dat::RecordId rod = 0;    ///< 1.6 m along x, around its origin
    dat::RecordId pole = 0;   ///< 1.6 m along z, around its origin
    dat::RecordId fence = 0;  ///< 3 m along x, from the origin
    dat::RecordId lamp = 0;   ///< a candle that lights its room
    /// The models that pickProp chooses from, by kind: pillars, screens, lamps, crates and the like.
    std::vector<std::vector<dat::RecordId>> standing;
    bool furnished = false;
    DungeonProps builtIn; ///< if furnished: furniture and lights of the built-in world
};
[[nodiscard]] Props addProps(ModelWriter& writer, bool furnished);

/// A random prop that stands on a floor.
[[nodiscard]] dat::RecordId pickProp(const Props& props, Random& random);

struct LeafSpec {
    double width = 1.0, height = 2.0; ///< metres
    bool opaque = true;               ///< else glass
    bool furnished = false;           ///< as in the built-in world
};
/// A door leaf, hinge at the origin, along +x.
[[nodiscard]] dat::RecordId addLeaf(ModelWriter& writer, const LeafSpec& leaf);

} // namespace limen::worlds
