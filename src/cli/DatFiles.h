#pragma once

#include "cli/Verbs.h"
#include "dat/File.h"
#include "engine/WorldSource.h"

#include <memory>

namespace limen::cli {

/// The dat files a command talks about: one by its name, or those of a directory, or the built-in world's.
struct DatFiles {
    std::unique_ptr<engine::WorldSource> source; ///< of a world; the list points into it
    std::unique_ptr<dat::File> single;
    std::vector<const dat::File*> list;
};

/// `path` empty: the built-in world's. Errors: those of opening them.
[[nodiscard]] Result<DatFiles> openDatFiles(const std::string& path);

/// "portal", "cell", "highres", "local".
[[nodiscard]] const char* nameOfRole(dat::FileRole role);

/// `limen dat export`.
void addExportVerb(CLI::App& dat, const Console& console, Choice& choice);
/// `limen dat pack`.
void addPackVerb(CLI::App& dat, const Console& console, Choice& choice);
/// `limen dat verify`.
void addVerifyVerb(CLI::App& dat, const Console& console, Choice& choice);

} // namespace limen::cli
