#pragma once

#include "core/Error.h"

#include <string>

namespace limen::placements {

/// The parts of `mariadb://USER@HOST:PORT/DATABASE?socket=PATH`; `mysql://` is equal. Parts may be percent-encoded.
struct ServerUrl {
    std::string user, host, database, socket; ///< user, host and socket may be empty
    unsigned port = 0;                        ///< 0: the usual one
};

/// True if a text begins with the scheme of a database server.
[[nodiscard]] bool isServerUrl(const std::string& text);

/// Errors: another scheme; a password, which other users of the computer could read; no database; a port that is
/// none; an option other than `socket`.
[[nodiscard]] Result<ServerUrl> parseServerUrl(const std::string& text);

} // namespace limen::placements
