#include "dat/codec/Hooks.h"

namespace limen::dat {
namespace {

constexpr std::size_t kAnimationRangeBytes = 16;
constexpr std::size_t kMinMotionBytes = 4; // counts and flags

std::size_t frameCountOf(ByteReader& io, const Animation&) {
    return io.count<std::uint32_t>("frames");
}
std::size_t frameCountOf(ByteWriter& io, const Animation& a) {
    io.count<std::uint32_t>(a.frames.size());
    return a.frames.size();
}

template <class IO, class A>
void animation(IO& io, RecordId key, A& a, BlockingParticle blocking) {
    ownId(io, key, a.id);
    io.value(a.flags);
    io.value(a.partCount);
    const std::size_t frameCount = frameCountOf(io, a);
    if (a.flags & Animation::kPositionFrames) {
        io.items(a.positionFrames, frameCount, kFrameBytes, "position frames",
                 [&](auto& one) { frame(io, one); });
    }
    io.items(a.frames, frameCount, minAnimationFrameBytes(a.partCount), "frames",
             [&](auto& one) { animationFrame(io, one, a.partCount, blocking); });
}

std::size_t rangeCountOf(ByteReader& io, const MotionData&) {
    return io.count<std::uint8_t>("animations of a motion");
}
std::size_t rangeCountOf(ByteWriter& io, const MotionData& m) {
    io.count<std::uint8_t>(m.animations.size());
    return m.animations.size();
}

template <class IO, class M>
void motion(IO& io, M& m) {
    const std::size_t rangeCount = rangeCountOf(io, m);
    io.value(m.bitfield);
    io.value(m.flags);
    io.align(m.padding);
    io.items(m.animations, rangeCount, kAnimationRangeBytes, "animations of a motion", [&](auto& range) {
        io.value(range.animation);
        io.value(range.low);
        io.value(range.high);
        io.value(range.fps);
    });
    if (m.flags & MotionData::kVelocity)
        io.value(m.velocity);
    if (m.flags & MotionData::kOmega)
        io.value(m.omega);
}

template <class IO, class List>
void motions(IO& io, List& list, const char* what) {
    io.template list<std::uint32_t>(list, 4 + kMinMotionBytes, what, [&](auto& keyed) {
        io.value(keyed.first);
        motion(io, keyed.second);
    });
}

template <class IO, class T>
void motionTable(IO& io, RecordId key, T& t) {
    ownId(io, key, t.id);
    io.value(t.defaultStyle);
    io.template list<std::uint32_t>(t.styleDefaults, 8, "style defaults", [&](auto& keyed) {
        io.value(keyed.first);
        io.value(keyed.second);
    });
    motions(io, t.cycles, "cycles");
    motions(io, t.modifiers, "modifiers");
    io.template list<std::uint32_t>(t.links, 8, "links", [&](auto& keyed) {
        io.value(keyed.first);
        motions(io, keyed.second, "motions of a link");
    });
}

} // namespace

template <>
Result<Animation> decode<Animation>(RecordId id, ByteView payload) {
    return decodeWithHooks<Animation>(
        id, payload,
        [&](ByteReader& io, Animation& a, BlockingParticle blocking) { animation(io, id, a, blocking); });
}
template <>
Result<Bytes> encode<Animation>(const Animation& a) {
    ByteWriter io;
    io.require((a.flags & Animation::kPositionFrames) || a.positionFrames.empty(),
               "position frames need kPositionFrames");
    animation(io, a.id, a, BlockingParticle::Bare);
    return io.take(a.id);
}

template <>
Result<MotionTable> decode<MotionTable>(RecordId id, ByteView payload) {
    return decodeWith<MotionTable>(id, payload,
                                   [&](ByteReader& io, MotionTable& t) { motionTable(io, id, t); });
}
template <>
Result<Bytes> encode<MotionTable>(const MotionTable& t) {
    ByteWriter io;
    motionTable(io, t.id, t);
    return io.take(t.id);
}

} // namespace limen::dat
