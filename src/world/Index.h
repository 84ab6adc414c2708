#pragma once

#include <cstdint>
#include <limits>

// Indices between the arrays of a World.
namespace limen::world {

using SpaceIndex = std::uint32_t;
using PortalIndex = std::uint32_t;
using ZoneIndex = std::uint32_t;
using InstanceIndex = std::uint32_t;

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
inline constexpr SpaceIndex kOutside = 0;    ///< spaces[0] is always the outside
inline constexpr ZoneIndex kOutsideZone = 0; ///< zones[0] has the outside as its only space

} // namespace limen::world
