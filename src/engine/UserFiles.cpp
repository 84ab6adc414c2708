#include "engine/UserFiles.h"

#include <system_error>

namespace limen::engine {

namespace fs = std::filesystem;

std::optional<fs::path> findFont(const std::vector<fs::path>& paths) {
    std::error_code error;
    for (const fs::path& path : paths)
        if (fs::is_regular_file(path, error))
            return path;
    return std::nullopt;
}

} // namespace limen::engine
