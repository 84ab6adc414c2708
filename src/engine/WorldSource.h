#pragma once

#include "dat/Archive.h"
#include "engine/BuiltInWorld.h"
#include "engine/ViewRequest.h"
#include "engine/placed/PlacedObjects.h"
#include "engine/places/FoundPlaces.h"

#include <optional>
#include <vector>

namespace limen::engine {

/// The open files of one world: the user's directory, or the built-in world in the cache.
struct WorldSource {
    std::optional<BuiltInWorld> builtIn; ///< keeps a temporary directory alive
    dat::Archive archive;
    world::WorldFile file;
    std::string datOption;                   ///< "" or " --dat DIR", for command lines in reports
    bool isSearched = false;                 ///< places, start and tour of `file` are from the records
    std::unique_ptr<PlacedObjects> placed{}; ///< of the world.db beside the files; null: there is none
};

/// Whether a world without world.json gets the places, start and tour that its records suggest. Skip saves the
/// search (docs/performance.md) where a position is given.
enum class PlaceSearch { Find, Skip };

/// Opens the dat files at `path`: a directory, one of its files, or a directory above it (DatDirectory.h).
/// Empty: the built-in world. Errors: findDatDirectory's; the archive's; the world file's; the built-in world
/// cannot be written; `progress` ended the search.
[[nodiscard]] Result<WorldSource> openWorldSource(const std::string& path,
                                                  PlaceSearch search = PlaceSearch::Find,
                                                  const SearchProgress& progress = {});

/// The dynamic objects for a load around `centre`: those of world.json, and the placed ones of world.db around it.
/// Errors: a damaged world.db.
[[nodiscard]] Result<world::MovingEntries> movingAround(const WorldSource& source, dat::BlockCoord centre,
                                                        const world::LoadOptions& options);

/// The same as resolvePlace() of ViewRequest.h for the places of `source`. A name that is no place can be that of an object of
/// world.db. Errors: as there; a damaged world.db.
[[nodiscard]] Result<ViewRequest> resolvePlace(ViewRequest request, const WorldSource& source);

/// The world's tour; without one, the tour that its records suggest, also beside a world.json that has places
/// only. May be empty. Records are searched once: not if `openWorldSource` did. Errors: a damaged index;
/// `progress` ended the search.
[[nodiscard]] Result<std::vector<world::Place>> tourOf(const WorldSource& source,
                                                       const SearchProgress& progress = {});

} // namespace limen::engine
