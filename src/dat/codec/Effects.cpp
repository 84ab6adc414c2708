#include "dat/codec/Hooks.h"

namespace limen::dat {
namespace {

template <class IO, class V>
void scaledVector(IO& io, V& v) {
    io.value(v.vector);
    io.value(v.least);
    io.value(v.most);
}

template <class IO, class F>
void fade(IO& io, F& f) {
    io.value(f.start);
    io.value(f.end);
    io.value(f.random);
}

template <class IO, class E>
void particleEmitter(IO& io, RecordId key, E& e) {
    ownId(io, key, e.id);
    io.value(e.unknown);
    io.value(e.emitterType);
    io.value(e.particleType);
    io.value(e.softwareGfxObj);
    io.value(e.gfxObj);
    io.value(e.birthrate);
    io.value(e.maxParticles);
    io.value(e.initialParticles);
    io.value(e.totalParticles);
    io.value(e.totalSeconds);
    io.value(e.lifespan);
    io.value(e.lifespanRandom);
    for (auto* v : {&e.offset, &e.a, &e.b, &e.c})
        scaledVector(io, *v);
    fade(io, e.scale);
    fade(io, e.translucency);
    io.value(e.isParentLocal);
}

template <class IO, class S>
void physicsScript(IO& io, RecordId key, S& s, BlockingParticle blocking) {
    ownId(io, key, s.id);
    io.template list<std::uint32_t>(s.hooks, 8 + kMinHookBytes, "hooks of a script", [&](auto& one) {
        io.value(one.startTime);
        hook(io, one.hook, blocking);
    });
}

template <class IO, class T>
void physicsScriptTable(IO& io, RecordId key, T& t) {
    ownId(io, key, t.id);
    io.template list<std::uint32_t>(t.scripts, 8, "kinds of play", [&](auto& keyed) {
        io.value(keyed.first);
        io.template list<std::uint32_t>(keyed.second, 8, "scripts", [&](auto& choice) {
            io.value(choice.most);
            io.value(choice.script);
        });
    });
}

} // namespace

template <>
Result<ParticleEmitter> decode<ParticleEmitter>(RecordId id, ByteView payload) {
    return decodeWith<ParticleEmitter>(
        id, payload, [&](ByteReader& io, ParticleEmitter& e) { particleEmitter(io, id, e); });
}
template <>
Result<Bytes> encode<ParticleEmitter>(const ParticleEmitter& e) {
    ByteWriter io;
    particleEmitter(io, e.id, e);
    return io.take(e.id);
}

template <>
Result<PhysicsScript> decode<PhysicsScript>(RecordId id, ByteView payload) {
    return decodeWithHooks<PhysicsScript>(id, payload,
                                          [&](ByteReader& io, PhysicsScript& s, BlockingParticle blocking) {
                                              physicsScript(io, id, s, blocking);
                                          });
}
template <>
Result<Bytes> encode<PhysicsScript>(const PhysicsScript& s) {
    ByteWriter io;
    physicsScript(io, s.id, s, BlockingParticle::Bare);
    return io.take(s.id);
}

template <>
Result<PhysicsScriptTable> decode<PhysicsScriptTable>(RecordId id, ByteView payload) {
    return decodeWith<PhysicsScriptTable>(
        id, payload, [&](ByteReader& io, PhysicsScriptTable& t) { physicsScriptTable(io, id, t); });
}
template <>
Result<Bytes> encode<PhysicsScriptTable>(const PhysicsScriptTable& t) {
    ByteWriter io;
    physicsScriptTable(io, t.id, t);
    return io.take(t.id);
}

} // namespace limen::dat
