#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

inline constexpr std::uint32_t kWatchmansPlay = 0x10; ///< sparks from a lantern

/// Records that animate and emit particles by themselves: scripts, emitters, animations
/// (docs/formats/effects_anim.md).
struct Effects {
    dat::RecordId candleScript = 0;     ///< a glow and smoke over a candle's wick, 0.2 m above its origin
    dat::RecordId cartScript = 0;       ///< dust behind a cart's wheels, emitted per metre
    dat::RecordId watchmansScripts = 0; ///< PhysicsScriptTable: kWatchmansPlay, weak and strong
    dat::RecordId dust = 0;             ///< ParticleEmitter: a puff where a foot is set down
    dat::RecordId campfire = 0, fountain = 0, whirligig = 0, vane = 0; ///< Setups that stand on the ground
};
[[nodiscard]] Effects addEffects(ModelWriter& writer);

/// PhysicsScript: snow around the place where it is played.
[[nodiscard]] dat::RecordId addSnowScript(ModelWriter& writer);

/// A hook, for an AnimationFrame or a script, that starts an emitter at a point of a part. `part` -1: the
/// whole object.
[[nodiscard]] dat::AnimationHook particleHook(dat::RecordId emitter, int part, const Vec3& at,
                                              std::uint32_t name = 0);

} // namespace limen::worlds
