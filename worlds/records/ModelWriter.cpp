#include "worlds/records/ModelWriter.h"

#include "core/Assert.h"
#include "worlds/records/Bsp.h"
#include "worlds/records/EncodedMesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>

namespace limen::worlds {

namespace {

dat::SphereF toSphere(const Aabb& box) {
    return {Vec3f(box.centre()), static_cast<float>(0.5 * glm::length(box.max - box.min))};
}

/// Intensity of a lantern in a room of some 6 m.
constexpr double kLantern = 3.5;

dat::LightInfo toLight(const Lamp& lamp) {
    dat::LightInfo light;
    light.frame.origin = Vec3f(lamp.position);
    light.colour.argb = lamp.colour;
    light.intensity = static_cast<float>(kLantern * lamp.intensity);
    light.falloff = static_cast<float>(lamp.range);
    return light;
}

template <class Record>
Record& madeHere(std::vector<Record>& records, dat::RecordId id) {
    const auto found =
        std::find_if(records.begin(), records.end(), [id](const Record& r) { return r.id == id; });
    LIMEN_ASSERT(found != records.end(), "this writer made the record");
    return *found;
}

} // namespace

dat::Frame toFrame(const Placement& placement) {
    const double half = 0.5 * placement.turn * std::numbers::pi / 180.0;
    double w = std::cos(half);
    double z = std::sin(half);
    const double halfTurns = placement.turn / 180.0;
    if (halfTurns == std::floor(halfTurns)) {
        w = std::round(w);
        z = std::round(z);
    }
    return {Vec3f(placement.origin), Quatf(static_cast<float>(w), 0.0f, 0.0f, static_cast<float>(z))};
}

dat::RecordId ModelWriter::addMesh(const FaceMesh& mesh, bool solid) {
    EncodedMesh encoded = encodeMesh(mesh.faces());
    dat::GfxObj object;
    object.id = nextGfxObj_++;
    object.flags = dat::GfxObj::kDrawing;
    object.surfaces = {encoded.surfaces.begin(), encoded.surfaces.end()};
    object.sortCenter = Vec3f(mesh.bounds().centre());
    if (solid) {
        PhysicsMesh physics = physicsOf(mesh.faces(), encoded.polygons);
        if (!physics.polygons.empty()) {
            object.flags |= dat::GfxObj::kPhysics;
            object.physicsPolygons = std::move(physics.polygons);
            object.physicsBsp = std::move(physics.tree);
        }
    }
    object.vertexArray = std::move(encoded.vertexArray);
    object.polygons = std::move(encoded.polygons);
    object.drawingBsp = buildDrawingBsp(mesh.faces());
    records_.gfxObjs.push_back(std::move(object));
    return records_.gfxObjs.back().id;
}

dat::RecordId ModelWriter::addAnimation(std::vector<dat::AnimationFrame> frames) {
    dat::Animation animation;
    animation.id = nextAnimation_++;
    animation.partCount = frames.empty() ? 0 : static_cast<std::uint32_t>(frames.front().parts.size());
    animation.frames = std::move(frames);
    records_.animations.push_back(std::move(animation));
    return records_.animations.back().id;
}

dat::RecordId ModelWriter::addMotionTable(dat::MotionTable table) {
    table.id = nextMotionTable_++;
    records_.motionTables.push_back(std::move(table));
    return records_.motionTables.back().id;
}

dat::RecordId ModelWriter::addEmitter(dat::ParticleEmitter emitter) {
    emitter.id = nextEmitter_++;
    records_.particleEmitters.push_back(emitter);
    return emitter.id;
}

dat::RecordId ModelWriter::addScript(std::vector<dat::ScriptedHook> hooks) {
    records_.physicsScripts.push_back({nextScript_++, std::move(hooks)});
    return records_.physicsScripts.back().id;
}

dat::RecordId ModelWriter::addScriptTable(dat::PhysicsScriptTable table) {
    table.id = nextScriptTable_++;
    records_.physicsScriptTables.push_back(std::move(table));
    return records_.physicsScriptTables.back().id;
}

void ModelWriter::setLevels(dat::RecordId gfxObj, std::vector<dat::DegradeLevel> levels) {
    dat::GfxObj& object = madeHere(records_.gfxObjs, gfxObj);
    object.flags |= dat::GfxObj::kHasDegrade;
    object.degradeId = nextDegradeInfo_++;
    records_.degradeInfos.push_back({object.degradeId, std::move(levels)});
}

void ModelWriter::setLevels(dat::RecordId gfxObj, double upTo, const std::vector<FartherLevel>& farther) {
    LIMEN_ASSERT(!farther.empty(), "a record ends with a level that is drawn at every distance");
    constexpr std::uint32_t kMesh = 1;
    constexpr float kEvery = std::numeric_limits<float>::max();
    std::vector<dat::DegradeLevel> levels;
    float from = 0.0f;
    const auto add = [&](dat::RecordId mesh, double limit) {
        const auto most = static_cast<float>(limit);
        LIMEN_ASSERT(most > from, "levels are in the order of their distances");
        levels.push_back({mesh, kMesh, from, 0.5f * (from + most), most});
        from = most;
    };
    add(gfxObj, upTo);
    for (std::size_t k = 0; k + 1 < farther.size(); ++k)
        add(farther[k].gfxObj, farther[k].upTo);
    levels.push_back({farther.back().gfxObj, kMesh, from, kEvery, kEvery});
    setLevels(gfxObj, std::move(levels));
}

void ModelWriter::setEffects(dat::RecordId setup, const SetupEffects& effects) {
    dat::Setup& record = madeHere(records_.setups, setup);
    record.script = effects.script;
    record.scriptTable = effects.scriptTable;
    record.animation = effects.animation;
}

dat::RecordId ModelWriter::addSetup(const std::vector<SetupPart>& parts, const std::vector<Lamp>& lamps,
                                    dat::RecordId motionTable) {
    std::map<dat::RecordId, const dat::GfxObj*> meshes;
    for (const dat::GfxObj& object : records_.gfxObjs)
        meshes[object.id] = &object;
    dat::Setup setup;
    setup.id = nextSetup_++;
    setup.flags = dat::Setup::kFreeHeading;
    dat::AnimationFrame pose;
    Aabb bounds;
    for (const SetupPart& part : parts) {
        setup.parts.push_back(part.gfxObj);
        pose.parts.push_back(toFrame(part.at));
        const dat::GfxObj& mesh = *meshes.at(part.gfxObj);
        setup.flags |= (mesh.flags & dat::GfxObj::kPhysics) != 0 ? dat::Setup::kPhysicsBsp : 0u;
        for (const auto& [key, vertex] : mesh.vertexArray.vertices)
            bounds.include(place(part.at, Vec3(vertex.position)));
    }
    setup.placementFrames.emplace_back(dat::Setup::kPlacementDefault, pose);
    setup.placementFrames.emplace_back(dat::Setup::kPlacementResting, pose);
    setup.sortingSphere = toSphere(bounds);
    setup.selectionSphere = setup.sortingSphere;
    setup.height = static_cast<float>(bounds.max.z);
    setup.radius =
        static_cast<float>(0.5 * std::hypot(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y));
    setup.stepUp = 0.4f;
    setup.stepDown = 0.4f;
    for (std::size_t k = 0; k < lamps.size(); ++k)
        setup.lights.emplace_back(static_cast<std::int32_t>(k), toLight(lamps[k]));
    setup.motionTable = motionTable;
    records_.setups.push_back(std::move(setup));
    return records_.setups.back().id;
}

} // namespace limen::worlds
