#pragma once

#include "placements/sql/Tokens.h"

#include <filesystem>

// Archives of SQL files, through libarchive.
namespace limen::placements {

struct ArchivedFile {
    std::string name;       ///< within the archive, with '/'
    std::uint64_t size = 0; ///< bytes; 0 if the archive does not say
};

/// The regular files of an archive, in its order. Errors: no archive that libarchive knows; a damaged one.
[[nodiscard]] Result<std::vector<ArchivedFile>> listArchive(const std::filesystem::path& path);

/// Calls `read` for each regular file of an archive, in its order. It need not read all bytes. Errors: as
/// listArchive(); it unpacks to more than 100 times its size and 64 MiB; those of `read`.
[[nodiscard]] Result<void>
readArchive(const std::filesystem::path& path,
            const std::function<Result<void>(const ArchivedFile& file, const ReadBytes& bytes)>& read);

} // namespace limen::placements
