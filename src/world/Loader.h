#pragma once

#include "dat/Archive.h"
#include "world/MovingEntries.h"
#include "world/World.h"

namespace limen::world {

struct LoadOptions {
    int radius = 4;         ///< blocks each way around the centre
    bool mergeZones = true; ///< false: every cell its own zone; the picture must be the same
    /// Levels of detail change at so many times the distances of their records; infinite: the nearest at any distance.
    double detail = 1.0;
    int farRadius = 0; ///< blocks beyond `radius` up to so many have their ground alone
    friend bool operator==(const LoadOptions&, const LoadOptions&) = default;
};

class LoadCache;

/// What makes a load faster and changes nothing of what it yields.
struct LoadHelp {
    LoadCache* cache = nullptr; ///< of the same archive
    unsigned threads = 1;       ///< that blocks are built on, this one among them; at least 1
};

/// Loads the landblocks around `centre` with all they hold. Blocks and records that do not exist are skipped;
/// a block whose own data is damaged is left out and reported in World::findings. Errors: nothing at all
/// could be loaded, or the Region is unreadable while there is terrain (a world without a Region is dungeons
/// only). A centre block that is a pure dungeon is loaded alone, without a far tier. Of `moving`, what refers to cells that are not
/// loaded is left out; what refers to nothing at all is reported in World::findings.
[[nodiscard]] Result<World> loadWorld(const dat::Archive& archive, dat::BlockCoord centre,
                                      const LoadOptions& options, const MovingEntries& moving = {},
                                      const LoadHelp& help = {});

/// True for a block of cells without landscape or buildings, though it may have a LandBlock record: all its heights are 0.
[[nodiscard]] bool isDungeon(const dat::Archive& archive, dat::BlockCoord coord);

/// The space of a cell id, or kNone.
[[nodiscard]] SpaceIndex findCell(const World& world, dat::RecordId cellId);

/// The block that holds a global position; coordinates clamped to the map.
[[nodiscard]] dat::BlockCoord blockAt(const Vec3& position);

/// How far a global position lies outside a block, on the level; metres, 0 within.
[[nodiscard]] double metresBeside(dat::BlockCoord block, const Vec3& position);

/// Height of the ground at a global position, by the triangle there; NaN where no terrain is resident.
[[nodiscard]] double terrainHeight(const World& world, double x, double y);

} // namespace limen::world
