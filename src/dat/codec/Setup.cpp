#include "dat/codec/Hooks.h"

namespace limen::dat {
namespace {

constexpr std::size_t kLightBytes = 4 + kFrameBytes + 4 + 12;

template <class IO, class Locations>
void locations(IO& io, Locations& list, const char* what) {
    io.template list<std::int32_t>(list, 8 + kFrameBytes, what, [&](auto& location) {
        io.value(location.key);
        io.value(location.part);
        frame(io, location.frame);
    });
}

template <class IO, class S>
void placementFrames(IO& io, S& s, std::size_t partCount, BlockingParticle blocking) {
    const std::size_t minBytes = 4 + partCount * kFrameBytes + 4;
    io.template list<std::int32_t>(s.placementFrames, minBytes, "placement frames", [&](auto& keyed) {
        io.value(keyed.first);
        io.items(keyed.second.parts, partCount, kFrameBytes, "part frames",
                 [&](auto& part) { frame(io, part); });
        io.template list<std::uint32_t>(keyed.second.hooks, kMinHookBytes, "animation hooks",
                                        [&](auto& one) { hook(io, one, blocking); });
    });
}

template <class IO, class S>
void lights(IO& io, S& s) {
    io.template list<std::int32_t>(s.lights, kLightBytes, "lights", [&](auto& keyed) {
        io.value(keyed.first);
        auto& light = keyed.second;
        frame(io, light.frame);
        colour(io, light.colour);
        io.value(light.intensity);
        io.value(light.falloff);
        io.value(light.coneAngle);
    });
}

std::size_t partCountOf(ByteReader& io, const Setup&) {
    return io.count<std::uint32_t>("parts");
}
std::size_t partCountOf(ByteWriter& io, const Setup& s) {
    io.count<std::uint32_t>(s.parts.size());
    return s.parts.size();
}

template <class IO, class S>
void setup(IO& io, RecordId key, S& s, BlockingParticle blocking) {
    ownId(io, key, s.id);
    io.value(s.flags);
    const std::size_t partCount = partCountOf(io, s);
    io.array(s.parts, partCount);
    if (s.flags & Setup::kParents)
        io.array(s.parents, partCount);
    if (s.flags & Setup::kScales)
        io.array(s.scales, partCount);
    locations(io, s.holdingLocations, "holding locations");
    locations(io, s.connectionPoints, "connection points");
    placementFrames(io, s, partCount, blocking);
    io.template list<std::uint32_t>(s.cylSpheres, 20, "collision cylinders", [&](auto& c) {
        io.value(c.low);
        io.value(c.radius);
        io.value(c.height);
    });
    io.template list<std::uint32_t>(s.spheres, 16, "collision spheres", [&](auto& one) { sphere(io, one); });
    for (auto* f : {&s.height, &s.radius, &s.stepUp, &s.stepDown})
        io.value(*f);
    sphere(io, s.sortingSphere);
    sphere(io, s.selectionSphere);
    lights(io, s);
    for (auto* i : {&s.animation, &s.script, &s.motionTable, &s.soundTable, &s.scriptTable})
        io.value(*i);
}

bool hasBlockingParticle(ByteView payload) {
    // Cheap and generous: any word of that value anywhere. It only decides whether a second try is worth
    // making.
    for (std::size_t i = 0; i + 4 <= payload.size(); ++i) {
        if (payload[i] == std::byte{kCreateBlockingParticleHook} && payload[i + 1] == std::byte{0} &&
            payload[i + 2] == std::byte{0} && payload[i + 3] == std::byte{0})
            return true;
    }
    return false;
}

} // namespace

template <>
Result<Setup> decode<Setup>(RecordId id, ByteView payload) {
    const auto attempt = [&](BlockingParticle blocking) {
        return decodeWith<Setup>(id, payload, [&](ByteReader& io, Setup& s) { setup(io, id, s, blocking); });
    };
    Result<Setup> first = attempt(BlockingParticle::Bare);
    if (first || !hasBlockingParticle(payload))
        return first;
    Result<Setup> second = attempt(BlockingParticle::LikeCreateParticle);
    return second ? std::move(second) : std::move(first);
}

template <>
Bytes encode<Setup>(const Setup& s) {
    LIMEN_ASSERT((s.flags & Setup::kParents) || s.parents.empty(), "parents need kParents");
    LIMEN_ASSERT((s.flags & Setup::kScales) || s.scales.empty(), "scales need kScales");
    ByteWriter io;
    setup(io, s.id, s, BlockingParticle::Bare);
    return io.take();
}

} // namespace limen::dat
