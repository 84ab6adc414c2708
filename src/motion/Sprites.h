#pragma once

#include "geometry/Vec.h"
#include "world/Moving.h"

#include <cstdint>

namespace limen::motion {

/// One living sprite of an emitter, in the emitter's frame: metres, seconds.
struct SpriteState {
    Vec3 offset{0.0}; ///< from the emitter's position
    double size = 0.0, opacity = 1.0;
};

/// Sprites that live at a time, by number: first .. last, empty if first > last. One was born before time 0 like any
/// other: an emitter has always been burning.
struct SpriteRange {
    std::int64_t first = 0, last = -1;
};
[[nodiscard]] SpriteRange livingAt(const world::Emitter& emitter, double seconds);

/// Sprite `number` at `seconds`. A pure function of both and the emitter's seed. Requires that it lives.
[[nodiscard]] SpriteState spriteAt(const world::Emitter& emitter, std::int64_t number, double seconds);

/// 0 <= r < 1, the same for the same arguments on every machine.
[[nodiscard]] double hashedUnit(std::uint64_t seed, std::int64_t number, std::uint32_t use);

} // namespace limen::motion
