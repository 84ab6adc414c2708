#include "viewer/Screenshots.h"

#include "core/platform/Files.h"
#include "output/OutputFile.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>

namespace limen::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStem = "limen-";

/// The number in a file name such as "limen-0012.png"; 0 for other names.
std::uint32_t numberOf(const fs::path& file) {
    const std::string stem = file.stem().string();
    if (!stem.starts_with(kStem))
        return 0;
    std::uint32_t number = 0;
    const char* end = stem.data() + stem.size();
    const auto [rest, error] = std::from_chars(stem.data() + kStem.size(), end, number);
    return error == std::errc() && rest == end ? number : 0;
}

/// One more than the largest number in the directory.
std::uint32_t nextNumber(const fs::path& directory) {
    std::uint32_t largest = 0;
    std::error_code error;
    for (fs::directory_iterator it(directory, error), end; !error && it != end; it.increment(error))
        if (platform::isText(it->path()))
            largest = std::max(largest, numberOf(it->path()));
    return largest + 1;
}

/// Creates an empty file. Returns false if it exists.
Result<bool> make(const fs::path& path) {
    std::FILE* file = platform::openFile(path, "wbx");
    if (file == nullptr && errno == EEXIST)
        return false;
    if (file == nullptr)
        return fail(ErrorCode::Unreadable, path.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    std::fclose(file);
    return true;
}

} // namespace

Result<fs::path> keepScreenshot(const fs::path& directory, const output::Picture& picture,
                                const std::string& command) {
    for (std::uint32_t number = nextNumber(directory);; ++number) {
        const std::string stem = fmt::format("{}{:04}", kStem, number);
        const fs::path png = directory / (stem + ".png");
        const Result<bool> made = make(png); // another window may save screenshots in the same directory
        if (!made)
            return Failure(made.error());
        if (!*made)
            continue;
        Result<void> written = output::writePicture(png, picture);
        if (written)
            written = output::writeFile(directory / (stem + ".txt"),
                                        std::string_view(fmt::format("{} -o {}-again.png\n", command, stem)));
        if (!written) {
            std::error_code ignored;
            fs::remove(png, ignored);
            return Failure(written.error());
        }
        return png;
    }
}

} // namespace limen::viewer
