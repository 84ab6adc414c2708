#include "dat/codec/Hooks.h"

#include <iterator>

namespace limen::dat {
namespace {

/// Payload bytes by type; -1 where the length depends on the payload.
constexpr int kPayloadBytes[] = {
    0,          // 0 NoOp
    4,          // 1 Sound
    4,          // 2 SoundTable
    28,         // 3 Attack
    0,          // 4 AnimationDone
    -1,         // 5 ReplaceObject
    4,          // 6 Ethereal
    16,         // 7 TransparentPart
    12,         // 8 Luminous
    16,         // 9 LuminousPart
    12,         // A Diffuse
    16,         // B DiffusePart
    8,          // C Scale
    8 + 28 + 4, // D CreateParticle
    4,          // E DestroyParticle
    4,          // F StopParticle
    4,          // 10 NoDraw
    0,          // 11 DefaultScript
    4,          // 12 DefaultScriptPart
    8,          // 13 CallPES
    12,         // 14 Transparent
    16,         // 15 SoundTweaked
    12,         // 16 SetOmega
    8,          // 17 TextureVelocity
    12,         // 18 TextureVelocityPart
    4,          // 19 SetLight
    0,          // 1A CreateBlockingParticle
};

/// ReplaceObject: u8 part, then a packed id of one or two u16 (docs/formats/primitives.md#packed-ids), then
/// padding to a multiple of 4.
std::size_t replaceObjectSize(ByteReader ahead) {
    [[maybe_unused]] const auto part = ahead.get<std::uint8_t>();
    return (ahead.get<std::uint16_t>() & 0x8000u) != 0 ? 8 : 4;
}

} // namespace

std::optional<std::size_t> hookPayloadSize(std::uint32_t type, BlockingParticle blocking) {
    if (type >= std::size(kPayloadBytes) || kPayloadBytes[type] < 0)
        return std::nullopt;
    if (type == kCreateBlockingParticleHook && blocking == BlockingParticle::LikeCreateParticle)
        type = kCreateParticleHook;
    return static_cast<std::size_t>(kPayloadBytes[type]);
}

void hook(ByteReader& io, AnimationHook& out, BlockingParticle blocking) {
    const std::size_t start = io.offset();
    io.value(out.type);
    io.value(out.direction);
    if (io.failed())
        return;
    auto size = hookPayloadSize(out.type, blocking);
    if (out.type == kReplaceObjectHook)
        size = replaceObjectSize(io);
    if (!size) {
        io.failAt(start, fmt::format("0x{:X} is not the type of an animation hook", out.type));
        return;
    }
    io.array(out.payload, *size);
}

void hook(ByteWriter& io, const AnimationHook& in, BlockingParticle) {
    io.require(in.type < std::size(kPayloadBytes),
               "an animation hook of an unknown type cannot be read back");
    io.value(in.type);
    io.value(in.direction);
    io.array(in.payload, in.payload.size());
}

bool mayHaveBlockingParticle(ByteView payload) {
    // Searches for the value at every offset.
    for (std::size_t i = 0; i + 4 <= payload.size(); ++i)
        if (payload[i] == std::byte{kCreateBlockingParticleHook} && payload[i + 1] == std::byte{0} &&
            payload[i + 2] == std::byte{0} && payload[i + 3] == std::byte{0})
            return true;
    return false;
}

} // namespace limen::dat
