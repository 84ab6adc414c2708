#pragma once

#include "doctor/retail/Census.h"

#include <set>
#include <unordered_map>
#include <vector>

// The two halves of a census: records of the portal file, and records of the cell file that name them.
namespace limen::doctor {

/// The properties of a Setup that are counted where it is placed.
struct SetupTraits {
    bool hasMarker = false, isAnimated = false, hasDefaultPlacementOnly = false;
    std::vector<std::pair<float, float>> lamps; ///< intensity, falloff
};

/// Distinct Setups of one kind of place.
using SetupSet = std::set<dat::RecordId>;

/// Adds records of the portal and the highres file, in ascending order of id.
class PortalCensus {
public:
    PortalCensus(const dat::Archive& archive, Census& census) : archive_(archive), census_(census) {}

    void add(const dat::GfxObj& object);
    void add(const dat::Setup& setup);
    void add(const dat::Palette& palette);
    void add(const dat::Surface& surface);
    void add(const dat::Environment& environment);
    void add(const dat::DegradeInfo& info);
    void add(const dat::Scene& scene);
    void add(const dat::ParticleEmitter& emitter);
    void add(const dat::PhysicsScript& script);
    void add(const dat::Animation& animation);
    void add(const dat::RenderSurface& picture); ///< of the highres file
    void finish();

    [[nodiscard]] const std::unordered_map<dat::RecordId, SetupTraits>& setups() const { return setups_; }

private:
    void countPolygons(const dat::PolygonList& polygons);
    void countClipMap(const dat::Surface& surface);
    void countHook(const dat::AnimationHook& hook);
    void countEmitterMeshes();
    void countOtherLevels();

    struct Levels {
        dat::RecordId first = 0;
        std::uint32_t mode = 0;
    };
    const dat::Archive& archive_;
    Census& census_;
    std::unordered_map<dat::RecordId, SetupTraits> setups_;
    std::unordered_map<dat::RecordId, dat::RecordId> levelsOf_; ///< DegradeInfo of a GfxObj
    std::unordered_map<dat::RecordId, Levels> levels_;          ///< by DegradeInfo
    std::set<dat::RecordId> emitterMeshes_;
    SetupSet scenery_, tilted_;
    std::vector<std::size_t> shapeVertices_;
};

/// Adds records of the cell file, in ascending order of id. The portal file comes first.
class CellCensus {
public:
    CellCensus(const PortalCensus& portal, Census& census) : portal_(portal), census_(census) {}

    void add(const dat::LandBlock& land);
    void add(const dat::LandBlockInfo& info);
    void add(const dat::EnvCell& cell);
    void finish();

private:
    void countLamp(float intensity, float falloff);

    const PortalCensus& portal_;
    Census& census_;
    SetupSet outdoor_, indoor_, placedLamps_, academy_;
    std::set<std::uint32_t> blocksWithMarkers_;
    std::vector<std::size_t> lampsOfCells_;
};

/// The number of Setups of a set that are animated.
[[nodiscard]] double animatedOf(const SetupSet& setups,
                                const std::unordered_map<dat::RecordId, SetupTraits>& traits);

} // namespace limen::doctor
