#pragma once

#include "core/Error.h"
#include "placements/Placements.h"

#include <filesystem>
#include <functional>

// The two sources of a Content: files of SQL, and a database server. Equal rows give equal content.
namespace limen::placements {

/// Reports the part that is done: 0..total, in units of the source. False cancels the import.
using ImportProgress = std::function<bool(std::size_t done, std::size_t total)>;

/// Reads files of SQL: directories, archives or single files; a later path replaces files of an earlier one
/// (sql/SqlFiles.h). Errors: a file cannot be read or understood; `progress` cancelled; no placed object and no
/// template is there.
[[nodiscard]] Result<Content> importSqlFiles(const std::vector<std::filesystem::path>& paths,
                                             const ImportProgress& progress = {});

/// A database server, and the way to it.
struct ServerAccess {
    std::string url;                  ///< server/ServerUrl.h
    std::string password;             ///< empty: none, or that of the option file
    std::filesystem::path optionFile; ///< of the client library; empty: none
};

/// Reads the tables of a MySQL or MariaDB server in one read-only transaction. Errors: a malformed URL; no server, no
/// such user, a wrong password, no such database; a table or a column that is missing or has another type;
/// `progress` cancelled; no placed object and no template is there.
[[nodiscard]] Result<Content> importServer(const ServerAccess& access, const ImportProgress& progress = {});

} // namespace limen::placements
