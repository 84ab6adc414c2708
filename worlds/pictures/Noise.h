#pragma once

#include "geometry/Vec.h"

#include <cstdint>

// Repeatable noise for textures and the shape of the ground. Every function is pure. Those that tile have
// period 1 in u and v, so a texture painted with them has no seam.
namespace limen::worlds {

/// 32 well-mixed bits.
[[nodiscard]] std::uint32_t hash(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);
/// The hash as a number in [0,1).
[[nodiscard]] double random01(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);

/// Gradient noise, about -1..1, on a lattice of cellsU × cellsV over the unit square; tiles.
/// ref: K. Perlin, Improving Noise, 2002.
[[nodiscard]] double gradientNoise(double u, double v, int cellsU, int cellsV, std::uint32_t seed);

/// Sum of `octaves` gradient noises, each with double frequency and half amplitude; about -1..1; tiles.
[[nodiscard]] double fbm(double u, double v, int cellsU, int cellsV, int octaves, std::uint32_t seed);

/// Sum of 1-|noise|: sharp ridges; 0..1; tiles.
[[nodiscard]] double ridged(double u, double v, int cellsU, int cellsV, int octaves, std::uint32_t seed);

/// Worley noise at a point: distances (in cells) to the nearest and second nearest feature point, and the
/// number of the nearest one. ref: S. Worley, A Cellular Texture Basis Function, 1996.
struct Cellular {
    double nearest = 0.0, second = 0.0;
    std::uint32_t id = 0;
};
/// `jitter` 0 is a regular grid, 1 fully random. Tiles.
[[nodiscard]] Cellular cellular(double u, double v, int cellsU, int cellsV, double jitter,
                                std::uint32_t seed);

/// 0 below `from`, 1 above `to`, a smooth curve between.
[[nodiscard]] double smoothStep(double from, double to, double value);

} // namespace limen::worlds
