#pragma once

#include "core/Error.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>

// Files by descriptor, as in POSIX: -1 is no file, and `errno` has the reason of a failure. Bytes are never translated.
namespace limen::platform {

/// Opens a new file for writing, or empties the present one.
[[nodiscard]] int createFile(const std::filesystem::path& path);
/// Opens a device or a pipe for writing.
[[nodiscard]] int openDevice(const std::filesystem::path& path);
/// Writes some of the bytes and returns their number; below 0 on failure, perhaps EINTR.
[[nodiscard]] std::ptrdiff_t writeSome(int file, std::span<const std::byte> bytes);
/// False if the system reports on closing that the bytes were not written.
[[nodiscard]] bool closeFile(int file);
/// Shortens a file to `length` bytes and continues there. Fails on devices.
[[nodiscard]] bool cutFile(int file, std::int64_t length);

/// True if a name can be text, without a loss. On Windows one with half of a surrogate pair of UTF-16 cannot: its conversion
/// throws. Elsewhere every name can.
[[nodiscard]] bool isText(const std::filesystem::path& path);
inline constexpr const char* kNoText =
    "a name has half of a surrogate pair of UTF-16, and cannot be text; rename the file or directory";

/// True if this user may write to a present file.
[[nodiscard]] bool isWritable(const std::filesystem::path& path);
/// Gives a file another name in its directory. A file of that name is replaced in one step.
[[nodiscard]] bool replaceFile(const std::filesystem::path& from, const std::filesystem::path& to);
/// Returns when the bytes of a file are on the disk.
[[nodiscard]] bool flushToDisk(const std::filesystem::path& path);
/// True for an `errno` of a full disk or an exhausted quota.
[[nodiscard]] bool isDiskFull(int error);

/// As std::fopen, for any path. The mode "wbx" fails if the file exists.
[[nodiscard]] std::FILE* openFile(const std::filesystem::path& path, const char* mode);

/// Makes a new, empty directory in the system's directory of temporary files. Errors: Unreadable, with its name.
[[nodiscard]] Result<std::filesystem::path> makeTemporaryDirectory();
/// The reason why no file can be created in a directory; empty: one can.
[[nodiscard]] std::string writeProblem(const std::filesystem::path& directory);

} // namespace limen::platform
