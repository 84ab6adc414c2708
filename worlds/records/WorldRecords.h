#pragma once

#include "dat/Ids.h"
#include "dat/records/Appearance.h"
#include "dat/records/Cells.h"
#include "dat/records/Effects.h"
#include "dat/records/Landscape.h"
#include "dat/records/Models.h"
#include "dat/records/Motion.h"
#include "dat/records/Textures.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace limen::worlds {

/// All records of a world, in the order in which they were made. Records hold their ids, except Surfaces.
struct WorldRecords {
    std::vector<dat::Palette> palettes;
    std::vector<dat::SurfaceTexture> surfaceTextures;
    std::vector<dat::RenderSurface> renderSurfaces;
    std::vector<std::pair<dat::RecordId, dat::Surface>> surfaces;
    std::vector<dat::GfxObj> gfxObjs;
    std::vector<dat::Setup> setups;
    std::vector<dat::Animation> animations;
    std::vector<dat::MotionTable> motionTables;
    std::vector<dat::DegradeInfo> degradeInfos;
    std::vector<dat::PaletteSet> paletteSets;
    std::vector<dat::ClothingTable> clothingTables;
    std::vector<dat::ParticleEmitter> particleEmitters;
    std::vector<dat::PhysicsScript> physicsScripts;
    std::vector<dat::PhysicsScriptTable> physicsScriptTables;
    std::vector<dat::Environment> environments;
    std::vector<dat::Scene> scenes;
    std::vector<dat::Region> regions;
    std::vector<dat::LandBlock> landBlocks;
    std::vector<dat::LandBlockInfo> landBlockInfos;
    std::vector<dat::EnvCell> envCells;
    nlohmann::ordered_json worldFile; ///< `world.json`
};

} // namespace limen::worlds
