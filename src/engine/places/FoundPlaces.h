#pragma once

#include "dat/Archive.h"
#include "world/Places.h"

#include <filesystem>
#include <functional>

// The places of a world without world.json, found from its records.
namespace limen::engine {

/// Receives the number of finished steps of a search and the number of all; false ends the search.
using SearchProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Fills `places`, `start` and `tour` from the records: towns, known spots of the original, dungeons, and for
/// a world without any of them a point above its land. Equal files give equal places. docs/world-file.md.
/// Errors: a damaged index; `progress` ended the search.
[[nodiscard]] Result<world::WorldFile> findPlaces(const dat::Archive& archive,
                                                  const SearchProgress& progress = {});

inline constexpr std::uint32_t kWorthCaching = 8 << 20; ///< bytes; smaller cell files are searched in no time

/// The same from the cache directory `root` (cacheRoot()), if the files are those of an earlier search;
/// otherwise searches and stores the result there. An empty root, or a cell file of less than `leastBytes`:
/// no cache.
[[nodiscard]] Result<world::WorldFile> findPlacesCached(const dat::Archive& archive,
                                                        const std::filesystem::path& root,
                                                        std::uint32_t leastBytes = kWorthCaching,
                                                        const SearchProgress& progress = {});

} // namespace limen::engine
