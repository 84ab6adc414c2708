#pragma once

#include "geometry/Vec.h"
#include "world/HashedUnit.h"
#include "world/Moving.h"

#include <cstdint>

namespace limen::motion {

/// One living sprite of an emitter, in the emitter's frame: metres, seconds.
struct SpriteState {
    Vec3 offset{0.0}; ///< from the emitter's position
    double size = 0.0, opacity = 1.0;
};

/// The numbers of the sprites that live at a time: first .. last, empty if first > last. Numbers may be
/// negative: an emitter has been burning for ever.
struct SpriteRange {
    std::int64_t first = 0, last = -1;
};
[[nodiscard]] SpriteRange livingAt(const world::Emitter& emitter, double seconds);

/// A pure function of the sprite's number, the time and the emitter's seed. Requires that the sprite lives.
[[nodiscard]] SpriteState spriteAt(const world::Emitter& emitter, std::int64_t number, double seconds);

using world::hashedUnit;

} // namespace limen::motion
