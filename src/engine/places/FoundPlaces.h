#pragma once

#include "dat/Archive.h"
#include "world/Places.h"

#include <filesystem>

// The places of a world without world.json, found from its records.
namespace limen::engine {

/// Fills `places`, `start` and `tour` from the records: towns, known spots of the original, dungeons, and for
/// a world without any of them a point above its land. Equal files give equal places. docs/world-file.md.
/// Errors: a damaged index.
[[nodiscard]] Result<world::WorldFile> findPlaces(const dat::Archive& archive);

inline constexpr std::uint32_t kWorthCaching = 8 << 20; ///< bytes; smaller cell files are searched in no time

/// The same from the cache directory `root` (cacheRoot()), if the files are those of an earlier search;
/// otherwise searches and stores the result there. An empty root, or a cell file of less than `leastBytes`:
/// no cache.
[[nodiscard]] Result<world::WorldFile> findPlacesCached(const dat::Archive& archive,
                                                        const std::filesystem::path& root,
                                                        std::uint32_t leastBytes = kWorthCaching);

/// Map coordinates of a position, e.g. "42.1N 33.6E" (docs/formats/landscape.md#map-coordinates).
[[nodiscard]] std::string mapCoordinates(const Vec3& position);

} // namespace limen::engine
