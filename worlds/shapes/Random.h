#pragma once

#include <cstdint>

namespace limen::worlds {

/// A random generator with the same numbers on every machine. ref: G. Steele, D. Lea, C. Flood, Fast
/// Splittable Pseudorandom Number Generators (SplitMix64), 2014.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    [[nodiscard]] std::uint32_t next() {
        state_ += 0x9E3779B97F4A7C15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return static_cast<std::uint32_t>((z ^ (z >> 31)) >> 32);
    }
    /// In [0, 1).
    [[nodiscard]] double unit() { return static_cast<double>(next()) * (1.0 / 4294967296.0); }
    [[nodiscard]] double between(double from, double to) { return from + (to - from) * unit(); }
    /// In 0 .. count-1; requires count > 0.
    [[nodiscard]] std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(next()) * count >> 32);
    }
    [[nodiscard]] bool chance(double share) { return unit() < share; }

private:
    std::uint64_t state_;
};

} // namespace limen::worlds
