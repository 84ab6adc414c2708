#pragma once

#include "placements/sql/Tokens.h"

#include <filesystem>

namespace limen::placements {

/// One text of SQL in a directory or in an archive, or a single file.
struct SqlFile {
    std::string name;       ///< relative to the directory, or within the archive, with '/'
    std::size_t source = 0; ///< index of the path that it was found at
    std::uint64_t size = 0; ///< bytes; 0 if the archive does not say
};

/// The files of SQL at some paths: directories, which are searched with their subdirectories, archives (zip, 7z,
/// tar and others that libarchive reads), or single files. A path that comes later replaces files of the same name:
/// of the same folder with a number (such as "9 WeenieDefaults") and with the same file name. Other files of equal
/// path are replaced, too. Files are in the order of the paths, then of their names.
/// Errors: a path that does not exist or cannot be read; no file of SQL is there.
[[nodiscard]] Result<std::vector<SqlFile>> findSqlFiles(const std::vector<std::filesystem::path>& paths);

/// The path that messages name: of a file in an archive, that of the archive and the name within it.
[[nodiscard]] std::filesystem::path shownPath(const std::vector<std::filesystem::path>& paths,
                                              const SqlFile& file);

/// The name under which later files replace earlier ones.
[[nodiscard]] std::string replacementKey(const std::string& name);

/// Reads a file that findSqlFiles() found.
using ReadSqlFile = std::function<Result<void>(const SqlFile& file, const ReadBytes& bytes)>;

/// Calls `read` for each of the files in order. `paths`: those of findSqlFiles(). Errors: a file cannot be read;
/// those of `read`.
[[nodiscard]] Result<void> readSqlFiles(const std::vector<std::filesystem::path>& paths,
                                        const std::vector<SqlFile>& files, const ReadSqlFile& read);

} // namespace limen::placements
