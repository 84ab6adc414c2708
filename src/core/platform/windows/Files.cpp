#include "core/platform/Files.h"

#include "core/platform/Process.h"
#include "core/platform/windows/Text.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <string_view>
#include <sys/stat.h>
#include <windows.h>

namespace limen::platform {
namespace {

namespace fs = std::filesystem;

constexpr int kMode = _S_IREAD | _S_IWRITE;

/// The `errno` of a Win32 error of a file.
int errnoOf(DWORD error) {
    switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
        return ENOENT;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
        return ENOSPC;
    case ERROR_ALREADY_EXISTS:
        return EEXIST;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_USER_MAPPED_FILE: // the file is open in another program
        return EACCES;
    default:
        return EIO;
    }
}

/// A name that no other call of any process has at this time.
std::wstring uniqueName(std::wstring_view begin) {
    static std::atomic<unsigned> count{0};
    return std::wstring(begin) + std::to_wstring(processId()) + L"-" + std::to_wstring(++count);
}

} // namespace

int createFile(const fs::path& path) {
    return _wsopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_TRUNC | _O_BINARY | _O_NOINHERIT, _SH_DENYNO,
                   kMode);
}

int openDevice(const fs::path& path) {
    return _wsopen(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, kMode);
}

std::ptrdiff_t writeSome(int file, std::span<const std::byte> bytes) {
    constexpr std::size_t kMost = std::size_t{1} << 24; // the number of bytes is an int
    return _write(file, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), kMost)));
}

bool closeFile(int file) {
    return _close(file) == 0;
}

bool cutFile(int file, std::int64_t length) {
    return _chsize_s(file, length) == 0 && _lseeki64(file, length, SEEK_SET) == length;
}

bool isText(const fs::path& path) {
    return isWellFormed(path.native());
}

bool isWritable(const fs::path& path) {
    return _waccess(path.c_str(), 2) == 0;
}

bool replaceFile(const fs::path& from, const fs::path& to) {
    if (MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING) != 0)
        return true;
    errno = errnoOf(GetLastError());
    return false;
}

bool flushToDisk(const fs::path& path) {
    const HANDLE file = CreateFileW(path.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                                    OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        return false;
    const bool isSafe = FlushFileBuffers(file) != 0;
    CloseHandle(file);
    return isSafe;
}

bool isDiskFull(int error) {
    return error == ENOSPC;
}

std::FILE* openFile(const fs::path& path, const char* mode) {
    const std::string_view text = mode;
    if (text.find('x') == std::string_view::npos)
        return _wfopen(path.c_str(), wideText(text).c_str());
    // The C library of Windows before its version 10 does not know "x".
    const int file =
        _wsopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, kMode);
    return file < 0 ? nullptr : _fdopen(file, "wb");
}

Result<fs::path> makeTemporaryDirectory() {
    std::error_code error;
    const fs::path directory = fs::temp_directory_path(error) / uniqueName(L"limen-");
    if (error || !fs::create_directory(directory, error))
        return fail(ErrorCode::Unreadable, directory.string(), "no directory can be made there");
    return directory;
}

std::string writeProblem(const fs::path& directory) {
    const fs::path probe = directory / uniqueName(L".limen-doctor-");
    const HANDLE file = CreateFileW(probe.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                                    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        return errorText(GetLastError());
    CloseHandle(file);
    return "";
}

} // namespace limen::platform
