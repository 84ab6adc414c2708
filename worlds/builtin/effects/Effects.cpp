#include "worlds/builtin/effects/Effects.h"

#include "worlds/builtin/people/MotionCommands.h"

#include <array>
#include <cstring>
#include <numbers>

namespace limen::worlds {

namespace {

using dat::ParticleType;

// Hooks. ref: docs/formats/effects_anim.md#hooks.
constexpr std::uint32_t kCreate = 0x0D, kCall = 0x13;

/// Appends the bytes of a value in the order of the format.
template <class Value>
void put(std::vector<std::uint8_t>& bytes, Value value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

dat::AnimationHook callHook(dat::RecordId script, double pause) {
    dat::AnimationHook hook{kCall, 0, {}};
    put(hook.payload, script);
    put(hook.payload, static_cast<float>(pause));
    return hook;
}

dat::ScaledVector vectorOf(const Vec3& v, double least = 1.0, double most = 1.0) {
    return {Vec3f(v), static_cast<float>(least), static_cast<float>(most)};
}

dat::Fade fadeOf(double start, double end, double random = 0.0) {
    return {static_cast<float>(start), static_cast<float>(end), static_cast<float>(random)};
}

/// A picture that faces the camera, `size` metres wide and high.
dat::RecordId addSprite(ModelWriter& writer, Material material, double size) {
    FaceMesh mesh;
    const double h = size / 2.0;
    mesh.card({Vec3(-h, 0, -h), Vec3(h, 0, -h), Vec3(h, 0, h), Vec3(-h, 0, h)}, material, true);
    const dat::RecordId id = writer.addMesh(mesh, false);
    writer.setLevels(id, {{id, 2, 0.0f, 60.0f, 120.0f}});
    return id;
}

dat::ParticleEmitter emitterOf(dat::RecordId gfxObj, ParticleType type, double interval, int most,
                               double life) {
    dat::ParticleEmitter e;
    e.softwareGfxObj = e.gfxObj = gfxObj;
    e.particleType = type;
    e.birthrate = interval;
    e.maxParticles = most;
    e.lifespan = life;
    e.scale = fadeOf(1.0, 1.0);
    return e;
}

struct Sprites {
    dat::RecordId flame = 0, spark = 0, smoke = 0, drop = 0;
};

Sprites addSprites(ModelWriter& writer) {
    Sprites s;
    s.flame = addSprite(writer, Material::Fire, 0.36);
    s.spark = addSprite(writer, Material::Firefly, 0.12);
    s.smoke = addSprite(writer, Material::Smoke, 0.4);
    FaceMesh drop; // a solid mesh, because it tumbles
    const std::array<Vec3, 4> p{Vec3(0, 0, 0.04), Vec3(0.03, 0, -0.02), Vec3(-0.02, 0.03, -0.02),
                                Vec3(-0.02, -0.03, -0.02)};
    drop.polygon({p[0], p[1], p[2]}, Material::Wax);
    drop.polygon({p[0], p[2], p[3]}, Material::Wax);
    drop.polygon({p[0], p[3], p[1]}, Material::Wax);
    drop.polygon({p[1], p[3], p[2]}, Material::Wax);
    s.drop = writer.addMesh(drop, false);
    return s;
}

dat::RecordId addFlames(ModelWriter& writer, const Sprites& sprites) {
    dat::ParticleEmitter e = emitterOf(sprites.flame, ParticleType::ParabolicLVGA, 0.06, 16, 0.8);
    e.lifespanRandom = 0.2;
    e.offset = vectorOf({0, 0, 1}, 0.0, 0.22);
    e.a = vectorOf({0, 0, 0.6}, 0.5, 1.0);
    e.b = vectorOf({0.05, 0, 0.7}, 0.5, 1.5);
    e.scale = fadeOf(1.2, 0.4, 0.2);
    e.translucency = fadeOf(0.2, 1.0);
    return writer.addEmitter(e);
}

dat::RecordId addSparks(ModelWriter& writer, const Sprites& sprites) {
    dat::ParticleEmitter e = emitterOf(sprites.spark, ParticleType::Swarm, 0.4, 10, 3.0);
    e.lifespanRandom = 1.0;
    e.offset = vectorOf({0, 0, 1}, 0.0, 0.3);
    e.a = vectorOf({0, 0, 0.7}, 0.6, 1.2);
    e.b = vectorOf({2.1, 1.7, 2.9}, 0.7, 1.3);
    e.c = vectorOf({0.25, 0.25, 0.1}, 0.5, 1.0);
    e.scale = fadeOf(1.0, 0.5);
    e.translucency = fadeOf(0.0, 0.8);
    return writer.addEmitter(e);
}

dat::RecordId addSmoke(ModelWriter& writer, const Sprites& sprites) {
    dat::ParticleEmitter e = emitterOf(sprites.smoke, ParticleType::GlobalVelocity, 0.5, 12, 5.0);
    e.offset = vectorOf({0, 0, 1}, 0.0, 0.2);
    e.a = vectorOf({0.12, 0.05, 0.8}, 0.8, 1.1);
    e.scale = fadeOf(1.0, 4.0, 0.3);
    e.translucency = fadeOf(0.55, 1.0);
    return writer.addEmitter(e);
}

/// A ring of stones, two logs, and fire.
dat::RecordId addCampfire(ModelWriter& writer, const Sprites& sprites) {
    FaceMesh mesh;
    for (int k = 0; k < 8; ++k) {
        const double a = 2.0 * std::numbers::pi * k / 8.0;
        const Vec3 at(0.55 * std::cos(a), 0.55 * std::sin(a), 0.0);
        mesh.box(at + Vec3(-0.12, -0.12, -0.3), at + Vec3(0.12, 0.12, 0.16), Material::Rock);
    }
    mesh.strut({-0.4, -0.1, 0.04}, {0.35, 0.15, 0.12}, {0, 0, 1}, 0.12, 0.12, Material::Bark);
    mesh.strut({0.1, -0.4, 0.10}, {-0.05, 0.4, 0.16}, {0, 0, 1}, 0.12, 0.12, Material::Embers);
    const dat::RecordId setup =
        writer.addSetup({{writer.addMesh(mesh), {}}}, {{{0.0, 0.0, 0.7}, 0xFFFF9C50, 0.8, 9.0}});
    const dat::RecordId script =
        writer.addScript({{0.0, particleHook(addFlames(writer, sprites), -1, {0, 0, 0.2}, 1)},
                          {0.0, particleHook(addSparks(writer, sprites), -1, {0, 0, 0.4}, 2)},
                          {0.0, particleHook(addSmoke(writer, sprites), -1, {0, 0, 1.1}, 3)}});
    writer.setEffects(setup, {.script = script});
    return setup;
}

/// A basin and a pillar with water that springs from its top and sometimes splashes to all sides.
dat::RecordId addFountain(ModelWriter& writer, const Sprites& sprites) {
    FaceMesh basin, pillar;
    for (const double s : {-1.0, 1.0}) {
        basin.box({s * 0.85 - 0.1, -0.95, -0.4}, {s * 0.85 + 0.1, 0.95, 0.35}, Material::StoneWall);
        basin.box({-0.75, s * 0.85 - 0.1, -0.4}, {0.75, s * 0.85 + 0.1, 0.35}, Material::StoneWall);
    }
    basin.polygon({{-0.75, -0.75, 0.22}, {0.75, -0.75, 0.22}, {0.75, 0.75, 0.22}, {-0.75, 0.75, 0.22}},
                  Material::WaterDark);
    pillar.box({-0.12, -0.12, -0.4}, {0.12, 0.12, 0.9}, Material::StoneWall);
    const dat::RecordId setup = writer.addSetup({{writer.addMesh(basin), {}}, {writer.addMesh(pillar), {}}});
    std::vector<dat::ScriptedHook> hooks;
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}) {
        dat::ParticleEmitter jet = emitterOf(sprites.drop, ParticleType::ParabolicLVGAGR, 0.05, 20, 0.65);
        jet.lifespanRandom = 0.08;
        jet.offset = vectorOf({0, 0, 1}, 0.0, 0.04);
        jet.a = vectorOf(side * 0.85 + Vec3(0, 0, 2.2), 0.85, 1.0);
        jet.b = vectorOf({0, 0, -9.8});
        jet.c = vectorOf({4.0, 3.0, 0.0}, 0.5, 1.5);
        jet.scale = fadeOf(1.0, 0.6, 0.3);
        hooks.push_back({0.0, particleHook(writer.addEmitter(jet), 1, {0, 0, 0.92})});
    }
    dat::ParticleEmitter splash = emitterOf(sprites.drop, ParticleType::Explode, 1.0, 30, 0.5);
    splash.initialParticles = splash.totalParticles = 30;
    splash.a = vectorOf({1.1, 0, 0}, 0.6, 1.0);
    splash.b = vectorOf({0, 0, -2.2});
    splash.c = vectorOf({1, 1, 0.8});
    const dat::RecordId script = writer.nextScript();
    hooks.push_back({0.5, particleHook(writer.addEmitter(splash), 1, {0, 0, 1.05})});
    hooks.push_back({1.5, callHook(script, 2.0)});
    writer.addScript(std::move(hooks));
    writer.setEffects(setup, {.script = script});
    return setup;
}

dat::Frame turnedFrame(const Vec3& origin, const Vec3& axis, double angle) {
    return {Vec3f(origin), Quatf(glm::angleAxis(angle, axis))};
}

/// A wheel of four sails on a post, turned by the Setup's own animation.
dat::RecordId addWhirligig(ModelWriter& writer) {
    constexpr double kHub = 2.6;
    constexpr int kFrames = 120;
    FaceMesh post, sails;
    post.beam({-0.06, -0.06, -0.6}, {0.06, 0.06, kHub + 0.1}, Material::Beam);
    sails.box({-0.05, -0.30, -0.05}, {0.05, -0.05, 0.05}, Material::Iron);
    for (int k = 0; k < 4; ++k) {
        const double a = std::numbers::pi / 2.0 * k;
        const Vec3 out(std::cos(a), 0.0, std::sin(a));
        const Vec3 hub(0.0, -0.2, 0.0); // offset so that no face is in the plane of a neighbour's
        sails.strut(hub + out * 0.05, hub + out * 0.3, {0, 1, 0}, 0.02, 0.05, Material::Iron);
        sails.strut(hub + out * 0.2, hub + out * 0.95, {0, 1, 0}, 0.03, 0.30, Material::Linen);
    }
    const std::vector<SetupPart> parts{{writer.addMesh(post), {}},
                                       {writer.addMesh(sails, false), {{0, 0, kHub}, 0.0}}};
    std::vector<dat::AnimationFrame> frames;
    for (int k = 0; k < kFrames; ++k) {
        const double a = 2.0 * std::numbers::pi * k / kFrames;
        frames.push_back({{toFrame(parts[0].at), turnedFrame(parts[1].at.origin, {0, 1, 0}, a)}, {}});
    }
    const dat::RecordId setup = writer.addSetup(parts);
    writer.setEffects(setup, {.animation = writer.addAnimation(std::move(frames))});
    return setup;
}

/// A vane on a post, swung to and fro by its motion table.
dat::RecordId addVane(ModelWriter& writer) {
    constexpr int kFrames = 48;
    FaceMesh post, arrow;
    post.beam({-0.04, -0.04, -0.6}, {0.04, 0.04, 3.0}, Material::Iron);
    arrow.beam({-0.02, -0.6, -0.02}, {0.02, 0.6, 0.02}, Material::Iron);
    arrow.box({-0.01, -0.62, -0.14}, {0.01, -0.30, 0.14}, Material::Iron);
    const std::vector<SetupPart> parts{{writer.addMesh(post), {}},
                                       {writer.addMesh(arrow, false), {{0, 0, 3.05}, 0.0}}};
    std::vector<dat::AnimationFrame> frames;
    for (int k = 0; k < kFrames; ++k) {
        const double phase = 2.0 * std::numbers::pi * k / kFrames;
        const double a = 0.5 * std::sin(phase) + 0.15 * std::sin(3.0 * phase);
        frames.push_back({{toFrame(parts[0].at), turnedFrame(parts[1].at.origin, {0, 0, 1}, a)}, {}});
    }
    dat::MotionData swings;
    swings.animations = {{writer.addAnimation(std::move(frames)), 0, -1, 6.0f}};
    dat::MotionTable table;
    table.defaultStyle = kNonCombat;
    table.styleDefaults = {{kNonCombat, kReady}};
    table.cycles = {{dat::motionKey(kNonCombat, kReady), swings}};
    return writer.addSetup(parts, {}, writer.addMotionTable(std::move(table)));
}

dat::RecordId addCandleScript(ModelWriter& writer, const Sprites& sprites) {
    dat::ParticleEmitter glow = emitterOf(sprites.spark, ParticleType::Still, 1.0, 2, 1.0);
    glow.scale = fadeOf(1.6, 2.2, 0.2);
    glow.translucency = fadeOf(0.6, 0.75, 0.1);
    dat::ParticleEmitter thread = emitterOf(sprites.smoke, ParticleType::LocalVelocity, 1.0, 2, 2.0);
    thread.a = vectorOf({0, 0, 0.2}, 0.8, 1.2);
    thread.scale = fadeOf(0.1, 0.3);
    thread.translucency = fadeOf(0.75, 1.0);
    thread.isParentLocal = 1;
    return writer.addScript({{0.0, particleHook(writer.addEmitter(glow), -1, {0, 0, 0.22})},
                             {0.0, particleHook(writer.addEmitter(thread), -1, {0, 0, 0.28})}});
}

dat::RecordId addCartScript(ModelWriter& writer, const Sprites& sprites) {
    dat::ParticleEmitter e = emitterOf(sprites.smoke, ParticleType::ParabolicGVGA, 0.6, 12, 2.0);
    e.emitterType = dat::ParticleEmitter::kPerMetre;
    e.offset = vectorOf({0, 0, 1}, 0.0, 0.1);
    e.a = vectorOf({0.05, 0, 0.25}, 0.5, 1.0);
    e.b = vectorOf({0, 0, -0.1});
    e.scale = fadeOf(0.5, 1.5, 0.2);
    e.translucency = fadeOf(0.75, 1.0);
    const dat::RecordId dust = writer.addEmitter(e);
    return writer.addScript(
        {{0.0, particleHook(dust, -1, {-0.7, -2.2, 0.1})}, {0.0, particleHook(dust, -1, {0.7, -2.2, 0.1})}});
}

dat::RecordId addDust(ModelWriter& writer, const Sprites& sprites) {
    dat::ParticleEmitter e = emitterOf(sprites.smoke, ParticleType::LocalVelocity, 0.1, 3, 0.9);
    e.initialParticles = e.totalParticles = 3;
    e.offset = vectorOf({0, 0, 1}, 0.02, 0.08);
    e.a = vectorOf({0, -0.15, 0.12}, 0.5, 1.0);
    e.scale = fadeOf(0.2, 0.7, 0.1);
    e.translucency = fadeOf(0.8, 1.0);
    return writer.addEmitter(e);
}

/// Sparks at the lantern: a weak and a strong script.
dat::RecordId addWatchmansScripts(ModelWriter& writer, const Sprites& sprites) {
    dat::PhysicsScriptTable table;
    table.scripts = {{kWatchmansPlay, {}}};
    for (const int most : {4, 12}) {
        dat::ParticleEmitter e = emitterOf(sprites.spark, ParticleType::Implode, 1.5 / most, most, 1.5);
        e.offset = vectorOf({0, 0, 0}, 0.05, 0.15);
        e.a = vectorOf({1.8, 0, 0}, 0.8, 1.2);
        e.c = vectorOf({1, 1, 1});
        e.scale = fadeOf(0.6, 0.3);
        e.translucency = fadeOf(0.2, 0.9);
        e.isParentLocal = 1;
        // Part 6 is the lantern; its origin is the flame.
        const dat::RecordId script =
            writer.addScript({{0.0, particleHook(writer.addEmitter(e), 6, {0, 0, 0})}});
        table.scripts.front().second.push_back({most == 4 ? 0.5f : 1.0f, script});
    }
    return writer.addScriptTable(std::move(table));
}

} // namespace

dat::AnimationHook particleHook(dat::RecordId emitter, int part, const Vec3& at, std::uint32_t name) {
    dat::AnimationHook hook{kCreate, 0, {}};
    put(hook.payload, emitter);
    put(hook.payload, part);
    for (int axis = 0; axis < 3; ++axis)
        put(hook.payload, static_cast<float>(at[axis]));
    for (const float q : {1.0f, 0.0f, 0.0f, 0.0f})
        put(hook.payload, q);
    put(hook.payload, name);
    return hook;
}

dat::RecordId addSnowScript(ModelWriter& writer) {
    constexpr double kAbove = 6.0, kAround = 10.0; // metres
    constexpr double kFastest = 1.0 / 60.0; // seconds between flakes; the shortest interval of any emitter
    std::vector<dat::ScriptedHook> hooks;
    for (const double size : {0.035, 0.05, 0.07}) {
        dat::ParticleEmitter e =
            emitterOf(addSprite(writer, Material::Snowflake, size), ParticleType::Swarm, kFastest, 420, 7.0);
        e.offset = vectorOf({0, 0, 1}, 0.0, kAround);
        e.a = vectorOf({0.3, 0.12, -1.3}, 0.75, 1.15);
        e.b = vectorOf({1.4, 1.1, 0.6}, 0.7, 1.3);
        e.c = vectorOf({0.22, 0.22, 0.05}, 0.5, 1.0);
        e.translucency = fadeOf(0.0, 0.2);
        hooks.push_back({0.0, particleHook(writer.addEmitter(e), -1, {0, 0, kAbove})});
    }
    return writer.addScript(std::move(hooks));
}

Effects addEffects(ModelWriter& writer) {
    const Sprites sprites = addSprites(writer);
    Effects effects;
    effects.candleScript = addCandleScript(writer, sprites);
    effects.cartScript = addCartScript(writer, sprites);
    effects.dust = addDust(writer, sprites);
    effects.watchmansScripts = addWatchmansScripts(writer, sprites);
    effects.campfire = addCampfire(writer, sprites);
    effects.fountain = addFountain(writer, sprites);
    effects.whirligig = addWhirligig(writer);
    effects.vane = addVane(writer);
    return effects;
}

} // namespace limen::worlds
