#pragma once

#include "dat/codec/Layout.h"

#include <optional>

// Animation hooks (formats/effects_anim.md): kept as bytes, whose number follows from the type.
namespace limen::dat {

inline constexpr std::uint32_t kReplaceObjectHook = 0x05;
inline constexpr std::uint32_t kCreateParticleHook = 0x0D;
inline constexpr std::uint32_t kCreateBlockingParticleHook = 0x1A;
inline constexpr std::size_t kMinHookBytes = 8;

/// How the one hook whose payload is not settled is read: without a payload, or with CreateParticle's.
enum class BlockingParticle { Bare, LikeCreateParticle };

/// Payload bytes of a hook type; no value for an unknown type and for ReplaceObject, whose payload tells its
/// own length.
[[nodiscard]] std::optional<std::size_t> hookPayloadSize(std::uint32_t type, BlockingParticle blocking);

void hook(ByteReader& io, AnimationHook& out, BlockingParticle blocking);
void hook(ByteWriter& io, const AnimationHook& in, BlockingParticle blocking);

} // namespace limen::dat
