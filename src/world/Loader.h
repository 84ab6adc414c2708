#pragma once

#include "dat/Archive.h"
#include "world/Lookup.h"
#include "world/MovingEntries.h"
#include "world/World.h"

#include <atomic>

namespace limen::world {

struct LoadOptions {
    int radius = 4;         ///< blocks each way around the centre that are loaded with everything
    bool mergeZones = true; ///< false: each cell is a zone of its own; the picture must be the same
    /// Factor on the distances at which levels of detail change; infinite: the nearest level at every
    /// distance.
    double detail = 1.0;
    int farRadius = 0; ///< blocks each way; beyond `radius`, their ground alone is loaded
    Readings readings{};
    friend bool operator==(const LoadOptions&, const LoadOptions&) = default;
};

class LoadCache;

/// Progress of a load, for another thread. Both threads may use it at any time.
struct LoadProgress {
    std::atomic<std::size_t> blocks{0};   ///< number of landblocks to read; 0: not known yet
    std::atomic<std::size_t> done{0};     ///< of them are read
    std::atomic<bool> isCancelled{false}; ///< set it to end the load with an error
};

/// Means to make a load faster, and to watch it. They do not change its result.
struct LoadHelp {
    LoadCache* cache = nullptr;       ///< of the same archive; null: none
    unsigned threads = 1;             ///< that read blocks, including the calling one; at least 1
    LoadProgress* progress = nullptr; ///< null: none
};

/// Loads the landblocks around `centre` with their content. Blocks and records that do not exist are skipped.
/// A damaged record is left out, with a finding. A centre block that is a pure dungeon is loaded alone,
/// without a far tier. Entries of `moving` that refer to unloaded cells are left out; entries that refer to
/// something that does not exist are findings.
/// Errors: no block could be loaded; the load was cancelled; or there is terrain and the Region cannot be read (without a Region
/// there are dungeons only).
[[nodiscard]] Result<World> loadWorld(const dat::Archive& archive, dat::BlockCoord centre,
                                      const LoadOptions& options, const MovingEntries& moving = {},
                                      const LoadHelp& help = {});

/// True for a block of cells without landscape or buildings. Its LandBlock record, if there is one, has
/// heights of 0 only.
[[nodiscard]] bool isDungeon(const dat::Archive& archive, dat::BlockCoord coord);

} // namespace limen::world
