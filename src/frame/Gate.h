#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace limen::frame {

/// Ways to keep each space within its openings (docs/gates.md). All draw the same scene from the same openings.
enum class Gate : std::uint8_t {
    Ownership, ///< each pixel has an owner, and each fragment is tested: exact
    Planes,    ///< walls and ground are clipped by the regions of their space
    Depth      ///< spaces are drawn in an order, with depth written at openings between them
};
inline constexpr std::array<Gate, 3> kGates{Gate::Ownership, Gate::Planes, Gate::Depth};

[[nodiscard]] constexpr std::string_view nameOf(Gate gate) {
    constexpr std::array<std::string_view, kGates.size()> kNames{"ownership", "planes", "depth"};
    return kNames[static_cast<std::size_t>(gate)];
}

/// The gate after this one; the first after the last.
[[nodiscard]] constexpr Gate nextGate(Gate gate) {
    return kGates[(static_cast<std::size_t>(gate) + 1) % kGates.size()];
}

/// None for an unknown name.
[[nodiscard]] constexpr std::optional<Gate> gateNamed(std::string_view name) {
    for (const Gate gate : kGates)
        if (nameOf(gate) == name)
            return gate;
    return std::nullopt;
}

} // namespace limen::frame
