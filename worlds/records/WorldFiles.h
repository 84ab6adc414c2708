#pragma once

#include "core/Error.h"
#include "worlds/records/WorldRecords.h"

#include <filesystem>

namespace limen::worlds {

/// Writes a world's records to `directory` (made if missing): `client_portal.dat`, `client_cell_1.dat`,
/// `world.json`. Errors: the directory or a file cannot be written.
[[nodiscard]] Result<void> writeWorldFiles(const WorldRecords& records,
                                           const std::filesystem::path& directory);

} // namespace limen::worlds
