#include "doctor/retail/Counts.h"

#include "doctor/retail/Judges.h"

#include <array>

namespace limen::doctor {
namespace {

constexpr const char* kTests = "tests of public readers against end-of-retail files";
constexpr const char* kCount = "published count over the archive";
constexpr const char* kFormat = "format survey of the archive";
constexpr const char* kDrawing = "published notes on the client's drawing";

using T = Tally;
constexpr auto kCounts = std::to_array<CountFact>({
    {"records.gfxObjs", kCount, T::GfxObjs, 15318, T::GfxObjs},
    {"records.setups", kCount, T::Setups, 5935, T::Setups},
    {"records.surfaces", kCount, T::Surfaces, 6152, T::Surfaces},
    {"records.environments", kTests, T::Environments, 772, T::Environments},
    {"records.degradeInfos", kDrawing, T::DegradeInfos, 4131, T::DegradeInfos},
    {"records.emitters", kDrawing, T::Emitters, 2051, T::Emitters},
    {"records.landBlocks", "the size of the map", T::LandBlocks, 65025, T::LandBlocks},
    {"records.envCells", "rounded count of a test", T::EnvCells, 735000, T::EnvCells, Rule::Equal, 1000},
    {"records.highresPictures", kTests, T::HighresPictures, 2295, T::HighresPictures},
    {"records.unreadable", kTests, T::Unreadable, 0, T::Entries},
    {"entries.compressed", kFormat, T::CompressedEntries, 0, T::Entries},
    {"entries.oddVersions", kFormat, T::OddVersions, 0, T::Entries},
    {"entries.firstVersion", kFormat, T::FirstVersion, 0, T::Entries},

    {"meshes.vertices", kCount, T::Vertices, 615119, T::GfxObjs},
    {"meshes.zeroNormals", kCount, T::ZeroNormals, 16043, T::GfxObjs},
    {"meshes.withZeroNormals", kCount, T::ObjectsWithZeroNormals, 1000, T::GfxObjs},
    {"meshes.twoSurfaceSides", kFormat, T::TwoSurfaceSides, 11, T::GfxObjs},
    {"meshes.uvBit8", kFormat, T::UvBit8, 0, T::GfxObjs},
    {"shapes", kTests, T::CellShapes, 3145, T::Environments},
    {"shapes.vertices", kTests, T::CellShapeVertices, 45320, T::Environments},
    {"shapes.medianVertices", kTests, T::MedianShapeVertices, 10, T::Environments},
    {"shapes.mostVertices", kTests, T::MostShapeVertices, 113, T::Environments},

    {"palettes.otherSizes", kTests, T::OtherPalettes, 0, T::Palettes},
    {"land.otherSizes", kTests, T::OtherLandBlocks, 0, T::LandBlocks},
    {"land.unusedBits", kTests, T::OddTerrainWords, 0, T::LandBlocks},
    {"cells.oddFlags", kTests, T::OddCellFlags, 0, T::EnvCells},
    {"buildings", kTests, T::Buildings, 6979, T::LandBlockInfos},
    {"buildings.withRooms", kTests, T::BuildingsWithRooms, 5464, T::LandBlockInfos},

    {"clip", kCount, T::ClipMaps, 721, T::Surfaces},
    {"clip.palettised", kCount, T::PalettisedClipMaps, 518, T::Surfaces},
    {"clip.other", kCount, T::OtherClipMaps, 203, T::Surfaces},
    {"clip.dxt5", kCount, T::ClipDxt5, 97, T::Surfaces},
    {"clip.a8r8g8b8", kCount, T::ClipArgb, 71, T::Surfaces},
    {"clip.dxt1", kCount, T::ClipDxt1, 27, T::Surfaces},
    {"clip.dxt3", kCount, T::ClipDxt3, 5, T::Surfaces},
    {"clip.a4r4g4b4", kCount, T::ClipArgb4, 2, T::Surfaces},
    {"clip.r8g8b8", kCount, T::ClipRgb, 1, T::Surfaces},
    {"clip.plain", kCount, T::ClipPlain, 640, T::Surfaces},
    {"clip.translucent", kCount, T::ClipTranslucent, 27, T::Surfaces},
    {"clip.alpha", kCount, T::ClipAlpha, 22, T::Surfaces},
    {"clip.alphaAdditive", kCount, T::ClipAlphaAdditive, 19, T::Surfaces},
    {"clip.additive", kCount, T::ClipAdditive, 12, T::Surfaces},
    {"clip.allThree", kCount, T::ClipAll, 1, T::Surfaces},
    {"surfaces.glowFlags", kCount, T::GlowFlags, 0, T::Surfaces},
    {"surfaces.inverseAlpha", kDrawing, T::InverseAlpha, 0, T::Surfaces},

    {"levels.mode1", kDrawing, T::LevelMode1, 13501, T::DegradeInfos},
    {"levels.mode2", kDrawing, T::LevelMode2, 259, T::DegradeInfos},
    {"levels.mode3", kDrawing, T::LevelMode3, 0, T::DegradeInfos},
    {"levels.mode4", kDrawing, T::LevelMode4, 11, T::DegradeInfos},
    {"levels.mode5", kDrawing, T::LevelMode5, 573, T::DegradeInfos},
    {"levels.otherLevel0", kDrawing, T::OtherLevel0, 229, T::DegradeInfos},

    {"scenery.tilted", kTests, T::TiltedScenery, 8, T::SceneRecords},
    {"scenery.tiltedSetups", kTests, T::TiltedScenerySetups, 6, T::SceneRecords},
    {"scenery.setups", kDrawing, T::ScenerySetups, 177, T::SceneRecords},
    {"scenery.animated", kDrawing, T::AnimatedScenery, 7, T::SceneRecords},
    {"outdoor.setups", kDrawing, T::OutdoorSetups, 1475, T::LandBlockInfos},
    {"outdoor.animated", kDrawing, T::AnimatedOutdoor, 22, T::LandBlockInfos},
    {"indoor.setups", kDrawing, T::IndoorSetups, 3580, T::EnvCells},
    {"indoor.animated", kDrawing, T::AnimatedIndoor, 59, T::EnvCells},
    {"setups.withScript", kDrawing, T::SetupsWithScript, 2161, T::Setups},
    {"setups.withoutScript", kDrawing, T::SetupsWithoutScript, 3774, T::Setups},
    {"indoor.things", kTests, T::CellThings, 593927, T::EnvCells},
    {"indoor.markers", kTests, T::CellMarkers, 152966, T::EnvCells},
    {"indoor.blocksWithMarkers", kTests, T::BlocksWithMarkers, 2130, T::EnvCells},
    {"academy.setups", kTests, T::AcademySetups, 170, T::AcademySetups},
    {"academy.defaultPlacementOnly", kTests, T::AcademySetupsDefaultOnly, 86, T::AcademySetups},

    {"lamps.setups", kCount, T::SetupsWithLamps, 608, T::Setups},
    {"lamps.setupsPlaced", kCount, T::PlacedSetupsWithLamps, 288, T::EnvCells},
    {"lamps.placed", kCount, T::PlacedLamps, 198334, T::EnvCells},
    {"lamps.litCells", kCount, T::LitCells, 146307, T::EnvCells},
    {"lamps.perCell.median", kCount, T::MedianLampsOfCell, 1, T::LitCells},
    {"lamps.perCell.p99", kCount, T::P99LampsOfCell, 5, T::LitCells, Rule::AtMost},
    {"lamps.perCell.most", kCount, T::MostLampsOfCell, 26, T::LitCells},
    {"lamps.intensity.least", kCount, T::LeastLampIntensity, 20, T::LitCells, Rule::Equal, 0.001},
    {"lamps.intensity.most", kCount, T::MostLampIntensity, 100, T::LitCells, Rule::Equal, 0.001},
    {"lamps.falloff.least", kCount, T::LeastLampFalloff, 1, T::LitCells, Rule::Equal, 0.001},
    {"lamps.falloff.most", kCount, T::MostLampFalloff, 15, T::LitCells, Rule::Equal, 0.001},

    {"emitters.meshes", kDrawing, T::EmitterMeshes, 341, T::Emitters},
    {"emitters.meshesWithLevels", kDrawing, T::EmitterMeshesWithLevels, 238, T::Emitters},
    {"emitters.mode1", kDrawing, T::EmitterMode1, 63, T::Emitters},
    {"emitters.mode2", kDrawing, T::EmitterMode2, 154, T::Emitters},
    {"emitters.mode5", kDrawing, T::EmitterMode5, 21, T::Emitters},
    {"calls", kDrawing, T::ScriptCalls, 458, T::ScriptCalls},
    {"calls.withPause", kDrawing, T::ScriptCallsWithPause, 104, T::ScriptCalls},
    {"calls.leastPause", kDrawing, T::LeastPause, 0.5, T::ScriptCallsWithPause, Rule::Equal, 0.001},
    {"calls.mostPause", kDrawing, T::MostPause, 900, T::ScriptCallsWithPause, Rule::Equal, 0.001},
    {"highres.jpegs", kTests, T::JpegPictures, 79, T::HighresPictures},
    {"highres.progressiveJpegs", kTests, T::ProgressiveJpegs, 6, T::HighresPictures},
});

} // namespace

std::span<const CountFact> countFacts() {
    return kCounts;
}

void judgeCounts(const Census& census, Ledger& ledger) {
    for (const CountFact& fact : kCounts) {
        std::optional<Numbers> found;
        if (census[fact.basis] > 0)
            found = Numbers{census[fact.tally]};
        ledger.judge(
            {"count." + std::string(fact.id), fact.source, {fact.expected}, fact.rule, fact.tolerance},
            std::move(found));
    }
}

} // namespace limen::doctor
