#include "placements/Import.h"
#include "placements/server/ServerUrl.h"

namespace limen::placements {

Result<Content> importServer(const ServerAccess& access, const ImportProgress&) {
    const Result<ServerUrl> url = parseServerUrl(access.url);
    if (!url)
        return Failure(url.error());
    return fail(ErrorCode::Unsupported, url->database,
                "this build has no MariaDB client; import the world's files of SQL instead");
}

} // namespace limen::placements
