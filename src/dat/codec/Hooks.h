#pragma once

#include "dat/codec/Layout.h"

#include <optional>

// Animation hooks (docs/formats/effects_anim.md) are kept as bytes; their number depends on the type.
namespace limen::dat {

inline constexpr std::uint32_t kReplaceObjectHook = 0x05;
inline constexpr std::uint32_t kCreateParticleHook = 0x0D;
inline constexpr std::uint32_t kCreateBlockingParticleHook = 0x1A;
inline constexpr std::size_t kMinHookBytes = 8;

/// The payload of CreateBlockingParticle: that of CreateParticle, or none in files of other writers.
enum class BlockingParticle { Bare, LikeCreateParticle };

/// Payload bytes of a hook type. No value for an unknown type, and for ReplaceObject, whose length depends on
/// the payload.
[[nodiscard]] std::optional<std::size_t> hookPayloadSize(std::uint32_t type, BlockingParticle blocking);

void hook(ByteReader& io, AnimationHook& out, BlockingParticle blocking);
void hook(ByteWriter& io, const AnimationHook& in, BlockingParticle blocking);

/// The least size in bytes of a frame of `parts` parts.
[[nodiscard]] constexpr std::size_t minAnimationFrameBytes(std::size_t parts) {
    return parts * kFrameBytes + 4;
}
template <class IO, class F>
void animationFrame(IO& io, F& f, std::size_t parts, BlockingParticle blocking) {
    io.items(f.parts, parts, kFrameBytes, "part frames", [&](auto& part) { frame(io, part); });
    io.template list<std::uint32_t>(f.hooks, kMinHookBytes, "animation hooks",
                                    [&](auto& one) { hook(io, one, blocking); });
}

/// False if the payload has no CreateBlockingParticle. May be true without one. Cheap.
[[nodiscard]] bool mayHaveBlockingParticle(ByteView payload);

/// decodeWith for records with hooks; `read(reader, record, blocking)`. If reading fails with the payload of
/// CreateBlockingParticle, reads again without.
template <class Record, class Read>
[[nodiscard]] Result<Record> decodeWithHooks(RecordId id, ByteView payload, Read&& read) {
    const auto attempt = [&](BlockingParticle blocking) {
        return decodeWith<Record>(id, payload, [&](ByteReader& io, Record& r) { read(io, r, blocking); });
    };
    Result<Record> first = attempt(BlockingParticle::LikeCreateParticle);
    if (first || !mayHaveBlockingParticle(payload))
        return first;
    Result<Record> second = attempt(BlockingParticle::Bare);
    return second ? std::move(second) : std::move(first);
}

} // namespace limen::dat
