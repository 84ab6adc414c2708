#pragma once

#include "geometry/Vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace limen::check {

/// Random numbers that depend on a seed and on numbers that name their purpose, and on nothing else: view 7
/// of a block is the same after any other views. SplitMix64 (Steele, Lea, Flood 2014).
class RandomGenerator {
public:
    RandomGenerator(std::uint64_t seed, std::initializer_list<std::uint64_t> purpose) : state_(seed) {
        for (const std::uint64_t number : purpose)
            state_ = next() ^ (number * 0x9E3779B97F4A7C15ull);
    }
    [[nodiscard]] std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    /// 0 <= x < 1.
    [[nodiscard]] double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
    /// Evenly spread over orders of magnitude. Requires 0 < low <= high.
    [[nodiscard]] double betweenLog(double low, double high) { return low * std::pow(high / low, unit()); }
    /// 0 .. count - 1. Requires count > 0.
    [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
    /// Unit length, evenly over the sphere.
    [[nodiscard]] Vec3 direction() {
        const double z = between(-1.0, 1.0), turn = between(0.0, 2.0 * std::numbers::pi);
        const double flat = std::sqrt(1.0 - z * z);
        return {flat * std::cos(turn), flat * std::sin(turn), z};
    }

private:
    std::uint64_t state_;
};

} // namespace limen::check
