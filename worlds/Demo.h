#pragma once

#include "core/Error.h"

#include <filesystem>

namespace limen::worlds {

/// Writes the built-in world to `directory` (made if missing): `client_portal.dat`, `client_cell_1.dat`,
/// `world.json`. Every call writes the same bytes. Errors: the directory or a file cannot be written.
[[nodiscard]] Result<void> writeBuiltInWorld(const std::filesystem::path& directory);

} // namespace limen::worlds
