#pragma once

#include "worlds/records/FaceMesh.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// A part of a Setup.
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

/// A level of detail of mode 1, drawn up to a distance. From distances 50 m are subtracted
/// (docs/formats/geometry.md#levels-of-detail). The last level is drawn at every greater distance.
struct FartherLevel {
    dat::RecordId gfxObj = 0; ///< 0: nothing
    double upTo = 0.0;        ///< metres; unused for the last level
};

/// Script, script table and animation that a Setup plays by itself; 0: none.
struct SetupEffects {
    dat::RecordId script = 0, scriptTable = 0, animation = 0;
};

/// Writes models: GfxObj, Setup, Animation, MotionTable, ParticleEmitter and script records. Ids ascend in
/// the order of the calls.
class ModelWriter {
public:
    explicit ModelWriter(WorldRecords& records) : records_(records) {}

    /// `solid`: with physics polygons (physicsOf).
    dat::RecordId addMesh(const FaceMesh& mesh, bool solid = true);
    /// `motionTable`: 0 for a model without motions.
    dat::RecordId addSetup(const std::vector<SetupPart>& parts, const std::vector<Lamp>& lamps = {},
                           dat::RecordId motionTable = 0);
    /// A Setup of one part.
    dat::RecordId addSingle(const FaceMesh& mesh) { return addSetup({{addMesh(mesh), {}}}); }
    /// Requires: all frames have the same number of parts.
    dat::RecordId addAnimation(std::vector<dat::AnimationFrame> frames);
    dat::RecordId addMotionTable(dat::MotionTable table);   ///< its id is filled in
    dat::RecordId addEmitter(dat::ParticleEmitter emitter); ///< its id is filled in
    dat::RecordId addScript(std::vector<dat::ScriptedHook> hooks);
    /// The id that the next script will get.
    [[nodiscard]] dat::RecordId nextScript() const { return nextScript_; }
    dat::RecordId addScriptTable(dat::PhysicsScriptTable table); ///< its id is filled in
    /// Sets the levels of detail of a GfxObj: itself up to `upTo`, then `farther`.
    void setLevels(dat::RecordId gfxObj, double upTo, const std::vector<FartherLevel>& farther);
    /// Sets the levels of detail of a GfxObj, or the effects of a Setup. Requires: this writer made the
    /// record.
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

} // namespace limen::worlds
