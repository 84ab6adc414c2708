#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

inline constexpr std::uint32_t kWatchmansPlay = 0x10; ///< sparks from a lantern

/// What moves of the records' own accord and sends out particles: scripts, emitters, animations (formats/effects_anim.md).
struct Effects {
    dat::RecordId candleScript =
        0; ///< a glow and a thread of smoke over a candle's wick at its origin's height of 0.2 m
    dat::RecordId cartScript = 0;       ///< dust behind a cart's wheels, by the metre
    dat::RecordId watchmansScripts = 0; ///< PhysicsScriptTable: kWatchmansPlay, weak and strong
    dat::RecordId dust = 0;             ///< ParticleEmitter: a puff where a foot is set down
    dat::RecordId campfire = 0, fountain = 0, whirligig = 0, vane = 0; ///< Setups, which stand on the ground
};
[[nodiscard]] Effects addEffects(ModelWriter& sink);

/// PhysicsScript: snow around where it is played.
[[nodiscard]] dat::RecordId addSnowScript(ModelWriter& sink);

/// A hook that starts an emitter at a place of a part, for an AnimationFrame or a script. `part` -1: of the whole object.
[[nodiscard]] dat::AnimationHook particleHook(dat::RecordId emitter, int part, const Vec3& at,
                                              std::uint32_t name = 0);

} // namespace limen::worlds
