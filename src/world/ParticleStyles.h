#pragma once

#include "world/Particles.h"

#include <optional>

namespace limen::world {

/// A ParticleEmitter record made fit for use: numbers that make no sense are none (no births, no spread), but `part` and `size`,
/// which only the mesh tells. Nothing if it can never show a particle.
[[nodiscard]] std::optional<ParticleStyle> particleStyleOf(const dat::ParticleEmitter& record);

/// How far a particle of a style comes from its place of birth's frame at most, over a whole life, with all that is drawn of it.
/// `offset`: the emitter's own from that frame.
[[nodiscard]] double particleReach(const ParticleStyle& style, const Vec3& offset);

} // namespace limen::world
