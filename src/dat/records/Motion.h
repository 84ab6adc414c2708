#pragma once

#include "dat/records/Models.h"

// Animation (0x03), MotionTable (0x09): docs/formats/effects_anim.md.
LIMEN_API_BEGIN
namespace limen::dat {

struct Animation {
    static constexpr std::uint32_t kPositionFrames = 1;
    std::uint32_t id = 0;
    std::uint32_t flags = 0;
    std::uint32_t partCount = 0; ///< of every frame; if a Setup has another number, the lesser is used
    std::vector<Frame>
        positionFrames; ///< flags & kPositionFrames: the object's own motion, one for each frame
    std::vector<AnimationFrame> frames;
};

/// A stretch of an animation.
struct AnimationRange {
    std::uint32_t animation = 0;    ///< Animation (0x03) id
    std::int32_t low = 0, high = 0; ///< frames, both played; high -1: to the last
    float fps = 0.0f;               ///< frames a second; negative: backwards
};

struct MotionData {
    static constexpr std::uint8_t kClearsModifiers = 1, kOnlyFromDefault = 2;
    static constexpr std::uint8_t kVelocity = 1, kOmega = 2;
    std::uint8_t bitfield = 0;
    std::uint8_t flags = 0;
    std::array<std::uint8_t, 1> padding{};  ///< the writer stores zeros
    std::vector<AnimationRange> animations; ///< played in order; 255 at most
    Vec3f velocity{0.0f};                   ///< flags & kVelocity; metres a second, of the object
    Vec3f omega{0.0f};                      ///< flags & kOmega; radians a second, of the object
};

/// The motions of an object in each style and substate. Repeated keys and their order are kept.
struct MotionTable {
    template <class Value>
    using Keyed = std::vector<std::pair<std::uint32_t, Value>>;
    std::uint32_t id = 0;
    std::uint32_t defaultStyle = 0;
    Keyed<std::uint32_t> styleDefaults; ///< style, substate
    Keyed<MotionData> cycles;           ///< by motionKey
    Keyed<MotionData> modifiers;        ///< by motionKey
    Keyed<Keyed<MotionData>> links;     ///< by motionKey of the old substate, then by the new substate
};

/// The key of a substate of a style.
[[nodiscard]] constexpr std::uint32_t motionKey(std::uint32_t style, std::uint32_t substate) {
    return (style << 16) | (substate & 0xFFFFFFu);
}

} // namespace limen::dat
LIMEN_API_END
