#pragma once

#include <cstdint>

// Ids of styles and motions in motion tables. ref: MotionCommand in the record schema of Chorizite's
// DatReaderWriter (dats.xml).
namespace limen::worlds {

inline constexpr std::uint32_t kNonCombat = 0x8000003D; ///< a style
inline constexpr std::uint32_t kReady = 0x41000003, kWalkForward = 0x45000005, kRunForward = 0x44000007;
inline constexpr std::uint32_t kOn = 0x4000000B, kOff = 0x4000000C; ///< of a door: open and shut

} // namespace limen::worlds
