#pragma once

#include "motion/Particles.h"

// Particle styles without random ranges, and sources of them.
namespace limen::motion {

/// A style whose random ranges are zero, except those of the arguments.
inline world::ParticleStyle plain(dat::ParticleType type = dat::ParticleType::Still) {
    world::ParticleStyle style;
    style.type = type;
    style.interval = 0.5;
    style.most = 4;
    style.lifespan = 3.0;
    style.scale = {1.0f, 1.0f, 0.0f};
    return style;
}

inline world::ParticleSource burning(const world::ParticleStyle& style) {
    world::ParticleSource source;
    source.interval = style.interval;
    source.isEverBurning = true;
    source.seed = 7;
    return source;
}

inline world::ParticleSource started(const world::ParticleStyle& style) {
    world::ParticleSource source = burning(style);
    source.isEverBurning = false;
    return source;
}

} // namespace limen::motion
