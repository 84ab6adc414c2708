#pragma once

#include "dat/Archive.h"
#include "engine/BuiltInWorld.h"
#include "world/Places.h"

#include <optional>

namespace limen::engine {

/// The files of one world, opened: the user's directory, or the built-in world in its cache.
struct WorldSource {
    std::optional<BuiltInWorld> builtIn; ///< keeps a borrowed directory alive
    dat::Archive archive;
    world::WorldFile file;
    std::string datOption; ///< "" or " --dat DIR", for command lines that are printed
};

/// Opens the dats of `directory`, or the built-in world when it is empty. Errors: the archive's, the world
/// file's; the built-in world cannot be written anywhere.
[[nodiscard]] Result<WorldSource> openWorldSource(const std::string& directory);

} // namespace limen::engine
