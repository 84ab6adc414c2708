#include "dat/Describe.h"
#include "dat/describe/Json.h"

namespace limen::dat {
namespace {

Json scaledVector(const ScaledVector& v) {
    return {{"vector", json(v.vector)}, {"least", number(v.least)}, {"most", number(v.most)}};
}

Json fade(const Fade& f) {
    return {{"start", number(f.start)}, {"end", number(f.end)}, {"random", number(f.random)}};
}

} // namespace

std::string describe(const ParticleEmitter& e) {
    return pretty({{"kind", "ParticleEmitter"},
                   {"id", hexId(e.id)},
                   {"emitter_type", e.emitterType},
                   {"particle_type", static_cast<std::int32_t>(e.particleType)},
                   {"software_gfx_obj", hexId(e.softwareGfxObj)},
                   {"gfx_obj", hexId(e.gfxObj)},
                   {"birthrate", number(e.birthrate)},
                   {"max_particles", e.maxParticles},
                   {"initial_particles", e.initialParticles},
                   {"total_particles", e.totalParticles},
                   {"total_seconds", number(e.totalSeconds)},
                   {"lifespan", number(e.lifespan)},
                   {"lifespan_random", number(e.lifespanRandom)},
                   {"offset", scaledVector(e.offset)},
                   {"a", scaledVector(e.a)},
                   {"b", scaledVector(e.b)},
                   {"c", scaledVector(e.c)},
                   {"scale", fade(e.scale)},
                   {"translucency", fade(e.translucency)},
                   {"parent_local", e.isParentLocal != 0}});
}

std::string describe(const PhysicsScript& s) {
    return pretty(
        {{"kind", "PhysicsScript"}, {"id", hexId(s.id)}, {"hooks", listOf(s.hooks, [](const auto& one) {
                                                              Json out = {{"at", number(one.startTime)}};
                                                              out.update(json(one.hook));
                                                              return out;
                                                          })}});
}

std::string describe(const PhysicsScriptTable& t) {
    return pretty({{"kind", "PhysicsScriptTable"},
                   {"id", hexId(t.id)},
                   {"scripts", listOf(t.scripts, [](const auto& keyed) {
                        return Json{
                            {"play", keyed.first},
                            {"choices", listOf(keyed.second, [](const auto& choice) {
                                 return Json{{"most", number(choice.most)}, {"script", hexId(choice.script)}};
                             })}};
                    })}});
}

} // namespace limen::dat
