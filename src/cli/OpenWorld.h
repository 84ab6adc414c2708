#pragma once

#include "cli/Console.h"
#include "engine/WorldSource.h"

// Opening a world with progress on the terminal.
namespace limen::cli {

/// engine::openWorldSource, with a line while files are opened and a bar while places are searched.
[[nodiscard]] Result<engine::WorldSource> openWorld(const Console& console, const std::string& dat,
                                                    engine::PlaceSearch search = engine::PlaceSearch::Find);

/// engine::tourOf, with a bar while records are searched.
[[nodiscard]] Result<std::vector<world::Place>> tourOf(const Console& console,
                                                       const engine::WorldSource& source);

} // namespace limen::cli
