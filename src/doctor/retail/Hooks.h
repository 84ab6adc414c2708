#pragma once

#include "dat/records/Models.h"

#include <cstring>
#include <optional>

// Payloads of the hooks that the facts are about (docs/formats/effects_anim.md).
namespace limen::doctor {

/// Seconds. A script called with a shorter pause begins at once.
inline constexpr float kImmediatePause = 0.0002f;

/// The word at an offset of a hook's payload; 0 behind its end.
template <class Word>
[[nodiscard]] Word payloadWord(const dat::AnimationHook& hook, std::size_t offset) {
    Word word{};
    if (offset + sizeof word <= hook.payload.size())
        std::memcpy(&word, hook.payload.data() + offset, sizeof word);
    return word;
}

/// A hook that calls a script.
struct ScriptCall {
    std::uint32_t script = 0;
    float pause = 0.0f; ///< seconds
};
[[nodiscard]] inline std::optional<ScriptCall> scriptCallOf(const dat::AnimationHook& hook) {
    constexpr std::uint32_t kCallPes = 0x13;
    if (hook.type != kCallPes)
        return std::nullopt;
    return ScriptCall{payloadWord<std::uint32_t>(hook, 0), payloadWord<float>(hook, 4)};
}

/// The emitter that a hook starts.
[[nodiscard]] inline std::optional<std::uint32_t> emitterOf(const dat::AnimationHook& hook) {
    constexpr std::uint32_t kCreateParticle = 0x0D;
    if (hook.type != kCreateParticle)
        return std::nullopt;
    return payloadWord<std::uint32_t>(hook, 0);
}

/// A hook that plays a wave.
struct WavePlayed {
    std::uint32_t wave = 0;
    float volume = 0.0f;
};
[[nodiscard]] inline std::optional<WavePlayed> waveOf(const dat::AnimationHook& hook) {
    constexpr std::uint32_t kSoundTweaked = 0x15;
    if (hook.type != kSoundTweaked)
        return std::nullopt;
    return WavePlayed{payloadWord<std::uint32_t>(hook, 0), payloadWord<float>(hook, 12)};
}

} // namespace limen::doctor
