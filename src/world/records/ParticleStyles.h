#pragma once

#include "world/Particles.h"

#include <optional>

namespace limen::world {

/// A ParticleEmitter record as a style. Numbers that are not finite or out of range become neutral values (no
/// births, no spread). `part` and `size` stay unset: they depend on the mesh. Nothing if the record can never
/// show a particle.
[[nodiscard]] std::optional<ParticleStyle> particleStyleOf(const dat::ParticleEmitter& record);

/// The greatest distance, in metres, of any point of a particle from the frame it is born in, over its whole
/// life. `offset`: the emitter's offset in that frame.
[[nodiscard]] double particleReach(const ParticleStyle& style, const Vec3& offset);

} // namespace limen::world
