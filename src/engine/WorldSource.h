#pragma once

#include "dat/Archive.h"
#include "engine/BuiltInWorld.h"
#include "world/Places.h"

#include <optional>
#include <vector>

namespace limen::engine {

/// The open files of one world: the user's directory, or the built-in world in the cache.
struct WorldSource {
    std::optional<BuiltInWorld> builtIn; ///< keeps a temporary directory alive
    dat::Archive archive;
    world::WorldFile file;
    std::string datOption; ///< "" or " --dat DIR", for command lines in reports
};

/// Whether a world without world.json gets the places, start and tour that its records suggest. Skip saves the
/// search (docs/performance.md) where a position is given.
enum class PlaceSearch { Find, Skip };

/// Opens the dat files at `path`: a directory, one of its files, or a directory above it (DatDirectory.h).
/// Empty: the built-in world. Errors: findDatDirectory's; the archive's; the world file's; the built-in world
/// cannot be written.
[[nodiscard]] Result<WorldSource> openWorldSource(const std::string& path,
                                                  PlaceSearch search = PlaceSearch::Find);

/// The world's tour; without one, the tour that its records suggest, also beside a world.json that has places
/// only. May be empty. Errors: a damaged index.
[[nodiscard]] Result<std::vector<world::Place>> tourOf(const WorldSource& source);

} // namespace limen::engine
