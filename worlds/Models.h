#pragma once

#include "worlds/Mesh.h"

namespace limen::worlds {

/// A part of a Setup: which GfxObj and where.
struct SetupPart {
    dat::RecordId gfxObj = 0;
    Placement at;
};

/// A lamp in a Setup, relative to the object.
struct Lamp {
    Vec3 position{0.0};
    std::uint32_t colour = 0xFFFFFFFF; ///< ARGB
    double intensity = 1.0;
    double range = 6.0; ///< metres
};

/// What a Setup does by itself; 0: nothing.
struct SetupEffects {
    dat::RecordId script = 0, scriptTable = 0, animation = 0;
};

/// Turns meshes into GfxObj and Setup records and hands out their ids, in the order asked for.
class ModelSink {
public:
    explicit ModelSink(WorldRecords& records) : records_(records) {}

    /// `solid`: with physics polygons, except for what one can walk through (foliage, flames, glass).
    dat::RecordId addMesh(const MeshBuilder& mesh, bool solid = true);
    /// `motionTable`: what it does, 0 for what only stands.
    dat::RecordId addSetup(const std::vector<SetupPart>& parts, const std::vector<Lamp>& lamps = {},
                           dat::RecordId motionTable = 0);
    /// A Setup of one part.
    dat::RecordId addSingle(const MeshBuilder& mesh) { return addSetup({{addMesh(mesh), {}}}); }
    /// Frames of as many parts each as the first.
    dat::RecordId addAnimation(std::vector<dat::AnimationFrame> frames);
    dat::RecordId addMotionTable(dat::MotionTable table);   ///< its id is filled in
    dat::RecordId addEmitter(dat::ParticleEmitter emitter); ///< likewise
    dat::RecordId addScript(std::vector<dat::ScriptedHook> hooks);
    [[nodiscard]] dat::RecordId nextScript() const {
        return nextScript_;
    }                                                            ///< what the next one will be called
    dat::RecordId addScriptTable(dat::PhysicsScriptTable table); ///< its id is filled in
    /// Gives a mesh, or a Setup, what it was made without. Requires: it was made here.
    void setLevels(dat::RecordId gfxObj, std::vector<dat::DegradeLevel> levels);
    void setEffects(dat::RecordId setup, const SetupEffects& effects);
    [[nodiscard]] WorldRecords& records() { return records_; }

private:
    WorldRecords& records_;
    dat::RecordId nextGfxObj_ = 0x01000100;
    dat::RecordId nextSetup_ = 0x02000100;
    dat::RecordId nextAnimation_ = 0x03000100;
    dat::RecordId nextMotionTable_ = 0x09000100;
    dat::RecordId nextDegradeInfo_ = 0x11000100;
    dat::RecordId nextEmitter_ = 0x32000100;
    dat::RecordId nextScript_ = 0x33000100;
    dat::RecordId nextScriptTable_ = 0x34000100;
};

/// The frame of a placement; exact for quarter turns.
[[nodiscard]] dat::Frame toFrame(const Placement& placement);

/// The physics polygons of a mesh: those whose faces one cannot walk through. Ids are the drawing polygons'
/// ids.
struct PhysicsMesh {
    dat::PolygonList polygons;
    dat::BspTree tree;
};
[[nodiscard]] PhysicsMesh physicsOf(const std::vector<Face>& faces, const dat::PolygonList& polygons);

} // namespace limen::worlds
