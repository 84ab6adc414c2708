#pragma once

#include <cstdint>

namespace limen::world {

/// A hash of the arguments as a number 0 <= r < 1, the same on every machine.
/// Ref: the finaliser of SplitMix64 (Steele, Lea, Flood 2014), twice.
[[nodiscard]] inline double hashedUnit(std::uint64_t seed, std::int64_t number, std::uint32_t use) {
    const auto mix = [](std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        return x ^ (x >> 31);
    };
    const std::uint64_t bits =
        mix(mix(seed * 0x9E3779B97F4A7C15u + use) + static_cast<std::uint64_t>(number) * 0x9E3779B97F4A7C15u);
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

} // namespace limen::world
