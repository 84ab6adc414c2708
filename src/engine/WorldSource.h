#pragma once

#include "dat/Archive.h"
#include "engine/BuiltInWorld.h"
#include "world/Places.h"

#include <optional>

namespace limen::engine {

/// The open files of one world: the user's directory, or the built-in world in the cache.
struct WorldSource {
    std::optional<BuiltInWorld> builtIn; ///< keeps a temporary directory alive
    dat::Archive archive;
    world::WorldFile file;
    std::string datOption; ///< "" or " --dat DIR", for command lines in reports
};

/// Opens the dat files of `directory`; empty: the built-in world. Errors: the archive's; the world file's;
/// the built-in world cannot be written.
[[nodiscard]] Result<WorldSource> openWorldSource(const std::string& directory);

} // namespace limen::engine
