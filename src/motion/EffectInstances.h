#pragma once

#include "motion/DynamicInstances.h"
#include "motion/DynamicStateInput.h"
#include "motion/ParticleCarrier.h"
#include "motion/Particles.h"

// Sprites of the world file's emitters, and particles of the records' sources.
namespace limen::motion {

void addSprites(const DynamicStateInput& input, DynamicInstances& instances);
void addParticles(const DynamicStateInput& input, DynamicInstances& instances);

/// A unit square that faces the eye.
struct SpriteShape {
    std::uint32_t part = world::kNone; ///< World::movingParts
    Vec2 size{1.0};                    ///< metres, across and up
    double opacity = 1.0;
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0}; ///< its axes, global
};
/// Appends a sprite without setting its spaces. `at`: its middle, global. Returns its index.
std::size_t addSprite(const SpriteShape& shape, const Vec3& at, DynamicInstances& instances);

/// The source and the frame of one particle.
struct ParticleOrigin {
    const world::ParticleSource& source;
    CarrierFrame frame;      ///< the particle's offset is relative to its origin
    std::uint32_t block = 0; ///< that the instance is stored relative to
};
/// Appends a particle and its spaces, if it is visible and ids for its polygons are left.
void addParticle(const DynamicStateInput& input, const ParticleOrigin& from, const ParticleState& state,
                 DynamicInstances& instances);

} // namespace limen::motion
