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
    const std::size_t minBytes = 4 + minAnimationFrameBytes(partCount);
    io.template list<std::int32_t>(s.placementFrames, minBytes, "placement frames", [&](auto& keyed) {
        io.value(keyed.first);
        animationFrame(io, keyed.second, partCount, blocking);
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

} // namespace

template <>
Result<Setup> decode<Setup>(RecordId id, ByteView payload) {
    return decodeWithHooks<Setup>(id, payload, [&](ByteReader& io, Setup& s, BlockingParticle blocking) {
        setup(io, id, s, blocking);
    });
}

template <>
Result<Bytes> encode<Setup>(const Setup& s) {
    ByteWriter io;
    io.require((s.flags & Setup::kParents) || s.parents.empty(), "parents need kParents");
    io.require((s.flags & Setup::kScales) || s.scales.empty(), "scales need kScales");
    setup(io, s.id, s, BlockingParticle::Bare);
    return io.take(s.id);
}

} // namespace limen::dat
