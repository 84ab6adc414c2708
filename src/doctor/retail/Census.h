#pragma once

#include "dat/Archive.h"

#include <array>
#include <functional>
#include <span>

// One pass over all records, which takes the counts that the facts state.
namespace limen::doctor {

/// A count, or a number derived from counts.
enum class Tally : std::uint8_t {
    // records
    GfxObjs,
    Setups,
    Palettes,
    Surfaces,
    Environments,
    DegradeInfos,
    SceneRecords,
    Emitters,
    Scripts,
    LandBlocks,
    LandBlockInfos,
    EnvCells,
    HighresPictures,
    Entries,
    Unreadable,
    // entries of the indices
    CompressedEntries,
    OddVersions,  ///< entries with a version other than 1, 2 and 3
    FirstVersion, ///< entries of version 1 that are no iteration records
    // meshes
    Vertices,
    ZeroNormals,
    ObjectsWithZeroNormals,
    TwoSurfaceSides, ///< polygons of sides 2
    UvBit8,          ///< polygons of stippling bit 8
    CellShapes,
    CellShapeVertices,
    MedianShapeVertices,
    MostShapeVertices,
    // palettes and land
    OtherPalettes,   ///< not of 2048 colours
    OtherLandBlocks, ///< not of 252 bytes
    OddTerrainWords, ///< with bits that no field uses
    OddCellFlags,    ///< cells with flags other than 1, 2 and 8
    Buildings,
    BuildingsWithRooms,
    // surfaces
    ClipMaps,
    PalettisedClipMaps,
    OtherClipMaps,
    ClipDxt5,
    ClipArgb,
    ClipDxt1,
    ClipDxt3,
    ClipArgb4,
    ClipRgb,
    ClipPlain,
    ClipTranslucent,
    ClipAlpha,
    ClipAlphaAdditive,
    ClipAdditive,
    ClipAll,
    GlowFlags,    ///< surfaces with the flags 0x20 or 0x40
    InverseAlpha, ///< surfaces with the flag 0x200
    // levels of detail
    LevelMode1,
    LevelMode2,
    LevelMode3,
    LevelMode4,
    LevelMode5,
    OtherLevel0, ///< records whose level 0 is not the object that names them
    // things placed
    TiltedScenery,
    TiltedScenerySetups,
    ScenerySetups,
    AnimatedScenery,
    OutdoorSetups,
    AnimatedOutdoor,
    IndoorSetups,
    AnimatedIndoor,
    SetupsWithScript,
    SetupsWithoutScript,
    CellThings,
    CellMarkers, ///< things in cells with a part that is never drawn
    BlocksWithMarkers,
    AcademySetups,
    AcademySetupsDefaultOnly, ///< with placement frame 0 alone
    // lamps
    SetupsWithLamps,
    PlacedSetupsWithLamps,
    PlacedLamps,
    LitCells,
    MedianLampsOfCell,
    P99LampsOfCell,
    MostLampsOfCell,
    LeastLampIntensity,
    MostLampIntensity,
    LeastLampFalloff,
    MostLampFalloff,
    // effects
    EmitterMeshes,
    EmitterMeshesWithLevels,
    EmitterMode1,
    EmitterMode2,
    EmitterMode5,
    ScriptCalls, ///< hooks that call a script
    ScriptCallsWithPause,
    LeastPause,
    MostPause,
    // pictures
    JpegPictures,
    ProgressiveJpegs,
    Count_ ///< the number of tallies
};
inline constexpr std::size_t kTallies = static_cast<std::size_t>(Tally::Count_);

/// Figures of one file of the archive.
struct FileCensus {
    bool isThere = false;
    std::uint64_t entries = 0;
    dat::IndexShape shape;
};

struct Census {
    std::array<double, kTallies> tallies{};
    std::array<FileCensus, 4> files; ///< by dat::FileRole

    [[nodiscard]] double operator[](Tally tally) const { return tallies[static_cast<std::size_t>(tally)]; }
    [[nodiscard]] double& operator[](Tally tally) { return tallies[static_cast<std::size_t>(tally)]; }
};

/// The GfxObjs that the original client never draws, ascending.
[[nodiscard]] std::span<const dat::RecordId> markers();
[[nodiscard]] bool isMarker(dat::RecordId gfxObj);

/// Called with the number of entries and of those done.
using CensusProgress = std::function<void(std::size_t total, std::size_t done)>;

/// Reads all records of the kinds that are counted. Damaged records are counted as Unreadable and left out.
/// Errors: the index of a file is damaged.
[[nodiscard]] Result<Census> takeCensus(const dat::Archive& archive, const CensusProgress& progress = {});

} // namespace limen::doctor
