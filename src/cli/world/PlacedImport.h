#pragma once

#include "cli/Console.h"

#include <string>
#include <vector>

// The import of placed objects: `limen world import`, and `limen view --import`.
namespace limen::cli {

struct PlacedImport {
    std::vector<std::string> sources; ///< directories, archives or files of SQL, or the URL of a server
    std::string dat;                  ///< write beside these dat files; empty: the working directory
    std::string output;               ///< write this file instead; empty: world.db
    std::string optionFile;           ///< with user and password of the server; empty: none
};

/// Reads the sources and writes the world.db, with progress on the terminal and one line for its content. Yields Interrupted
/// after a signal. Errors: those of the readers and the writer; nothing is half written.
[[nodiscard]] Result<Exit> importPlaced(const PlacedImport& arguments, const Console& console);

} // namespace limen::cli
