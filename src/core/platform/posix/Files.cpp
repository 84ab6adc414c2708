#include "core/platform/Files.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace limen::platform {

namespace fs = std::filesystem;

int createFile(const fs::path& path) {
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

int openDevice(const fs::path& path) {
    return ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
}

std::ptrdiff_t writeSome(int file, std::span<const std::byte> bytes) {
    return ::write(file, bytes.data(), bytes.size());
}

bool closeFile(int file) {
    return ::close(file) == 0;
}

bool cutFile(int file, std::int64_t length) {
    return ::ftruncate(file, length) == 0 && ::lseek(file, length, SEEK_SET) == length;
}

bool isText(const fs::path& /*path*/) {
    return true;
}

bool isWritable(const fs::path& path) {
    return ::access(path.c_str(), W_OK) == 0;
}

bool replaceFile(const fs::path& from, const fs::path& to) {
    return ::rename(from.c_str(), to.c_str()) == 0;
}

bool flushToDisk(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool isSafe = file >= 0 && ::fsync(file) == 0;
    if (file >= 0)
        ::close(file);
    return isSafe;
}

bool isDiskFull(int error) {
    return error == ENOSPC || error == EDQUOT;
}

std::FILE* openFile(const fs::path& path, const char* mode) {
    return std::fopen(path.c_str(), mode);
}

Result<fs::path> makeTemporaryDirectory() {
    std::error_code error;
    std::string pattern = (fs::temp_directory_path(error) / "limen-XXXXXX").string();
    if (error || ::mkdtemp(pattern.data()) == nullptr)
        return fail(ErrorCode::Unreadable, pattern, "no directory can be made there");
    return fs::path(pattern);
}

std::string writeProblem(const fs::path& directory) {
    std::string pattern = (directory / ".limen-doctor-XXXXXX").string();
    const int file = ::mkstemp(pattern.data());
    if (file < 0)
        return std::strerror(errno);
    ::close(file);
    ::unlink(pattern.c_str());
    return "";
}

} // namespace limen::platform
