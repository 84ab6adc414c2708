#pragma once

#include "placements/Placements.h"

#include <string>

// Content as files of SQL in the layout of the published world database, for import by importSqlFiles() or by a
// server.
namespace limen::placements {

/// A text, and its path below the directory of the export, with '/'.
struct SqlText {
    std::string path, text;
};

/// The file of one landblock: it removes the landblock's rows and inserts its objects and links. A parent comes before the
/// links from it.
[[nodiscard]] SqlText sqlOf(std::uint32_t id, const Landblock& landblock);

/// The file of one template.
[[nodiscard]] SqlText sqlOf(const Template& of);

} // namespace limen::placements
