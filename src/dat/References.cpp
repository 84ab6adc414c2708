#include "dat/References.h"

#include <cstring>

namespace limen::dat {
namespace {

constexpr std::uint32_t kReplaceObject = 0x05, kCreateParticle = 0x0D, kCallScript = 0x13;
constexpr RecordId kSurfaces = 0x08000000, kEnvironments = 0x0D000000, kGfxObjs = 0x01000000;

void named(RecordId id, RecordKind kind, const char* as, const ReferenceVisitor& visit) {
    if (id != 0)
        visit({id, kind, as});
}

void model(RecordId id, const char* as, const ReferenceVisitor& visit) {
    if (id != 0)
        visit(modelReference(id, as));
}

template <class Word>
Word wordAt(const AnimationHook& hook, std::size_t offset) {
    Word word{};
    if (offset + sizeof word <= hook.payload.size())
        std::memcpy(&word, hook.payload.data() + offset, sizeof word);
    return word;
}

/// A packed id (docs/formats/primitives.md#packed-ids).
RecordId packedId(const AnimationHook& hook, std::size_t offset, RecordId base) {
    const RecordId low = wordAt<std::uint16_t>(hook, offset);
    if ((low & 0x8000u) == 0)
        return base + low;
    return base + ((low & 0x3FFFu) << 16 | wordAt<std::uint16_t>(hook, offset + 2));
}

void hook(const AnimationHook& h, const ReferenceVisitor& visit) {
    switch (h.type) {
    case kReplaceObject:
        named(packedId(h, 1, kGfxObjs), RecordKind::GfxObj, "the mesh that a hook puts in place", visit);
        return;
    case kCreateParticle:
        named(wordAt<std::uint32_t>(h, 0), RecordKind::ParticleEmitter, "the emitter that a hook starts",
              visit);
        return;
    case kCallScript:
        named(wordAt<std::uint32_t>(h, 0), RecordKind::PhysicsScript, "the script that a hook calls", visit);
        return;
    default:
        return;
    }
}

void hooks(const std::vector<AnimationHook>& list, const ReferenceVisitor& visit) {
    for (const AnimationHook& one : list)
        hook(one, visit);
}

void motions(const MotionTable::Keyed<MotionData>& list, const ReferenceVisitor& visit) {
    for (const auto& keyed : list)
        for (const AnimationRange& range : keyed.second.animations)
            named(range.animation, RecordKind::Animation, "an animation", visit);
}

void cellsOf(RecordId record, const std::vector<std::uint16_t>& cells, const char* as,
             const ReferenceVisitor& visit) {
    for (const std::uint16_t low : cells)
        visit({(record & 0xFFFF0000u) | low, RecordKind::EnvCell, as});
}

void sky(const SkyDesc& s, const ReferenceVisitor& visit) {
    for (const DayGroup& group : s.dayGroups) {
        for (const SkyObject& object : group.objects) {
            model(object.object, "a sky object", visit);
            named(object.script, RecordKind::PhysicsScript, "a sky object's script", visit);
        }
        for (const SkyTimeOfDay& time : group.times)
            for (const SkyObjectReplace& replace : time.replaces)
                model(replace.gfxObj, "a sky object at another time", visit);
    }
}

} // namespace

template <>
void forEachReference(const GfxObj& g, const ReferenceVisitor& visit) {
    for (const RecordId id : g.surfaces)
        visit({id, RecordKind::Surface, "a surface"});
    named(g.degradeId, RecordKind::DegradeInfo, "its levels of detail", visit);
}

template <>
void forEachReference(const Setup& s, const ReferenceVisitor& visit) {
    for (const RecordId id : s.parts)
        named(id, RecordKind::GfxObj, "a part", visit);
    for (const auto& keyed : s.placementFrames)
        hooks(keyed.second.hooks, visit);
    named(s.animation, RecordKind::Animation, "its animation", visit);
    named(s.script, RecordKind::PhysicsScript, "its script", visit);
    named(s.motionTable, RecordKind::MotionTable, "its motions", visit);
    named(s.scriptTable, RecordKind::PhysicsScriptTable, "its scripts", visit);
}

template <>
void forEachReference(const Animation& a, const ReferenceVisitor& visit) {
    for (const AnimationFrame& frame : a.frames)
        hooks(frame.hooks, visit);
}

template <>
void forEachReference(const Palette&, const ReferenceVisitor&) {}

template <>
void forEachReference(const SurfaceTexture&, const ReferenceVisitor&) {}

template <>
void forEachReference(const RenderSurface& s, const ReferenceVisitor& visit) {
    named(s.defaultPalette, RecordKind::Palette, "its palette", visit);
}

template <>
void forEachReference(const Surface& s, const ReferenceVisitor& visit) {
    named(s.texture, RecordKind::SurfaceTexture, "its texture", visit);
    named(s.palette, RecordKind::Palette, "its palette", visit);
}

template <>
void forEachReference(const MotionTable& t, const ReferenceVisitor& visit) {
    motions(t.cycles, visit);
    motions(t.modifiers, visit);
    for (const auto& keyed : t.links)
        motions(keyed.second, visit);
}

template <>
void forEachReference(const Environment&, const ReferenceVisitor&) {}

template <>
void forEachReference(const PaletteSet& s, const ReferenceVisitor& visit) {
    for (const RecordId id : s.palettes)
        visit({id, RecordKind::Palette, "a palette"});
}

template <>
void forEachReference(const ClothingTable& t, const ReferenceVisitor& visit) {
    for (const auto& [setup, changes] : t.parts.entries) {
        visit({setup, RecordKind::Setup, "a model it is worn by"});
        for (const PartChange& change : changes) {
            named(change.gfxObj, RecordKind::GfxObj, "a changed part", visit);
            for (const TextureChange& texture : change.textures) {
                named(texture.from, RecordKind::SurfaceTexture, "a texture that is replaced", visit);
                named(texture.to, RecordKind::SurfaceTexture, "a texture in its place", visit);
            }
        }
    }
    for (const auto& keyed : t.palettes.entries) {
        named(keyed.second.icon, RecordKind::RenderSurface, "an icon", visit);
        for (const PaletteChange& change : keyed.second.changes)
            if (change.palettes != 0)
                visit({change.palettes, RecordKind::PaletteSet, RecordKind::Palette, "palettes"});
    }
}

template <>
void forEachReference(const DegradeInfo& d, const ReferenceVisitor& visit) {
    for (const DegradeLevel& level : d.levels)
        named(level.gfxObj, RecordKind::GfxObj, "a level of detail", visit);
}

template <>
void forEachReference(const Scene& s, const ReferenceVisitor& visit) {
    for (const SceneObject& object : s.objects)
        model(object.object, "an object", visit);
}

template <>
void forEachReference(const Region& r, const ReferenceVisitor& visit) {
    sky(r.sky, visit);
    for (const SceneType& type : r.sceneTypes)
        for (const RecordId id : type.scenes)
            visit({id, RecordKind::Scene, "a scene"});
    for (const auto* maps : {&r.texMerge.corners, &r.texMerge.sides, &r.texMerge.roads})
        for (const AlphaMap& map : *maps)
            visit({map.texture, RecordKind::SurfaceTexture, "a blend map"});
    for (const TerrainTexture& texture : r.texMerge.textures) {
        named(texture.texture, RecordKind::SurfaceTexture, "a ground texture", visit);
        named(texture.detailTexture, RecordKind::SurfaceTexture, "a detail texture", visit);
    }
}

template <>
void forEachReference(const ParticleEmitter& e, const ReferenceVisitor& visit) {
    named(e.softwareGfxObj, RecordKind::GfxObj, "its particles without hardware", visit);
    named(e.gfxObj, RecordKind::GfxObj, "its particles", visit);
}

template <>
void forEachReference(const PhysicsScript& s, const ReferenceVisitor& visit) {
    for (const ScriptedHook& one : s.hooks)
        hook(one.hook, visit);
}

template <>
void forEachReference(const PhysicsScriptTable& t, const ReferenceVisitor& visit) {
    for (const auto& keyed : t.scripts)
        for (const ScriptChoice& choice : keyed.second)
            named(choice.script, RecordKind::PhysicsScript, "a script", visit);
}

template <>
void forEachReference(const LandBlock& b, const ReferenceVisitor& visit) {
    if (b.hasObjects != 0)
        visit({(b.id & 0xFFFF0000u) | 0xFFFEu, RecordKind::LandBlockInfo, "its objects"});
}

template <>
void forEachReference(const LandBlockInfo& info, const ReferenceVisitor& visit) {
    const RecordId block = info.id & 0xFFFF0000u;
    constexpr std::uint32_t kMost = kLastCell - kFirstCell + 1u;
    for (std::uint32_t i = 0; i < std::min(info.numCells, kMost); ++i)
        visit({block | (kFirstCell + i), RecordKind::EnvCell, "one of its cells"});
    for (const Stab& object : info.objects)
        model(object.model, "an object", visit);
    for (const Building& building : info.buildings) {
        model(building.model, "a building", visit);
        for (const BuildingPortal& portal : building.portals) {
            if (portal.otherCellId != kOutdoors)
                visit(
                    {block | portal.otherCellId, RecordKind::EnvCell, "the cell behind a building's portal"});
            cellsOf(info.id, portal.stabs, "a cell seen through a building's portal", visit);
        }
    }
}

template <>
void forEachReference(const EnvCell& c, const ReferenceVisitor& visit) {
    for (const std::uint16_t low : c.surfaces)
        visit({kSurfaces | low, RecordKind::Surface, "a surface"});
    visit({kEnvironments | c.environment, RecordKind::Environment, "its shape"});
    for (const CellPortal& portal : c.portals) {
        if (portal.otherCellId != kOutdoors)
            visit(
                {(c.id & 0xFFFF0000u) | portal.otherCellId, RecordKind::EnvCell, "the cell behind a portal"});
    }
    cellsOf(c.id, c.visibleCells, "a cell of its list of those seen", visit);
    for (const Stab& object : c.statics)
        model(object.model, "an object", visit);
}

} // namespace limen::dat
