#pragma once

#include "cli/Verbs.h"
#include "dat/File.h"
#include "engine/WorldSource.h"

#include <memory>

namespace limen::cli {

/// The dat files of a command: one file, the files of a directory, or those of the built-in world.
struct DatFiles {
    std::unique_ptr<engine::WorldSource> source; ///< the world; `list` points into it
    std::unique_ptr<dat::File> single;
    std::vector<const dat::File*> list;
};

/// An empty `path` opens the built-in world. Errors: those of opening the files.
[[nodiscard]] Result<DatFiles> openDatFiles(const std::string& path);

/// The name of a role: "portal", "cell", "highres" or "local".
[[nodiscard]] const char* nameOfRole(dat::FileRole role);

/// `limen dat export`.
void addExportVerb(CLI::App& dat, const Console& console, Choice& choice);
/// `limen dat pack`.
void addPackVerb(CLI::App& dat, const Console& console, Choice& choice);
/// `limen dat verify`.
void addVerifyVerb(CLI::App& dat, const Console& console, Choice& choice);

} // namespace limen::cli
