#pragma once

#include "dat/records/Effects.h"
#include "support/MovingHut.h"

#include <cstring>

namespace limen::test {

/// A moving hut with records of effects: particle emitters, scripts, and Setups that start them.
struct EffectsHut {
    MovingHut hut;
    std::uint32_t spark =
        hut.source.addModel({Wall{rectangle({-0.1, 0, -0.1}, {0.1, 0, 0.1}), "glow", true}});
    std::uint32_t flake = hut.source.addModel({Wall{rectangle({-0.1, 0, -0.2}, {0.1, 0, 0.2}), "glow", true}},
                                              {{TestWorld::kItself, 2, 0, 0, 500}});
    std::uint32_t post = hut.source.addModel(boxExterior({-0.1, -0.1, 0}, {0.1, 0.1, 1}, "oak"));

    /// An emitter of static opaque sparks: one each half second, four at most, each for two seconds.
    static dat::ParticleEmitter emitter(std::uint32_t gfxObj) {
        dat::ParticleEmitter record;
        record.gfxObj = gfxObj;
        record.birthrate = 0.5;
        record.maxParticles = 4;
        record.lifespan = 2.0;
        record.scale = {1.0f, 1.0f, 0.0f};
        return record;
    }
    std::uint32_t add(dat::ParticleEmitter record) {
        record.id = nextEmitter_++;
        hut.source.portalFile().add(record);
        return record.id;
    }
    std::uint32_t addScript(std::vector<dat::ScriptedHook> hooks) {
        const dat::PhysicsScript script{nextScript_++, std::move(hooks)};
        hut.source.portalFile().add(script);
        return script.id;
    }
    [[nodiscard]] std::uint32_t nextScript() const { return nextScript_; }
    /// A post, and a second one 2 m above it, with a default script.
    std::uint32_t addScripted(std::uint32_t script) {
        dat::Setup setup;
        setup.parts = {post, post};
        dat::AnimationFrame rest;
        rest.parts = {frameAt({0, 0, 0}), frameAt({0, 0, 2})};
        setup.placementFrames = {{dat::Setup::kPlacementResting, rest}};
        setup.script = script;
        return hut.source.addSetup(setup);
    }

    static dat::AnimationHook hook(std::uint32_t type, const std::vector<std::uint32_t>& words) {
        dat::AnimationHook out{type, 0, {}};
        out.payload.resize(words.size() * 4);
        if (!words.empty())
            std::memcpy(out.payload.data(), words.data(), out.payload.size());
        return out;
    }
    static std::uint32_t word(float value) {
        std::uint32_t out = 0;
        std::memcpy(&out, &value, 4);
        return out;
    }
    static constexpr std::uint32_t kWhole = 0xFFFFFFFFu;
    static dat::AnimationHook create(std::uint32_t emitter, std::uint32_t part = kWhole,
                                     const Vec3f& offset = Vec3f(0.0f), std::uint32_t name = 0) {
        return hook(
            0x0D, {emitter, part, word(offset.x), word(offset.y), word(offset.z), word(1.0f), 0, 0, 0, name});
    }
    static dat::AnimationHook call(std::uint32_t script, float pause) {
        return hook(0x13, {script, word(pause)});
    }
    static dat::AnimationHook destroy(std::uint32_t name) { return hook(0x0E, {name}); }
    static dat::AnimationHook stop(std::uint32_t name) { return hook(0x0F, {name}); }

private:
    std::uint32_t nextEmitter_ = 0x32000001, nextScript_ = 0x33000001;
};

} // namespace limen::test
