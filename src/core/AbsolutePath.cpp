#include "core/AbsolutePath.h"

namespace limen {

std::filesystem::path absolutePath(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path whole =
        path.empty() ? std::filesystem::current_path(error) : std::filesystem::absolute(path, error);
    return error ? path : whole;
}

} // namespace limen
