#pragma once

#include "cli/Console.h"
#include "placements/WorldDb.h"
#include "world/Places.h"

#include <memory>

// The placed objects of a world, for the verbs of `limen world`: a world.db or a world.json.
namespace limen::cli {

/// One of the two is set.
struct PlacedWorld {
    std::unique_ptr<placements::WorldDb> database;
    std::unique_ptr<world::WorldFile> file;
    std::filesystem::path path; ///< of the file that was read
};

/// Opens a file, or the world.db or else the world.json of a directory; empty: the built-in world. Errors: neither is
/// there; those of the readers.
[[nodiscard]] Result<PlacedWorld> openPlacedWorld(const std::string& path);

} // namespace limen::cli
