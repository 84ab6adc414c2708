#pragma once

#include "output/Picture.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace limen::output {

/// Says now whether a file can be written at `path` later, by making and removing a file beside it. Nothing
/// is left behind and an existing file is not touched. Errors: a directory that is missing or not writable;
/// `path` is itself a directory or write-protected.
[[nodiscard]] Result<void> checkWritable(const std::filesystem::path& path);

/// Writes a whole file: beside its place first, then renamed over it, so that nobody ever meets half of it. A
/// device or pipe (/dev/null) is written to as it is. Errors: as checkWritable; a full disk.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view text);

/// Writes a picture as PNG. Errors: as writeFile; no pixels.
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& path, const Picture& picture);

/// Makes a directory and its parents if they are missing. Errors: it cannot be, or is a file.
[[nodiscard]] Result<void> makeDirectory(const std::filesystem::path& path);

/// A whole text file of at most `limit` bytes. Errors: missing, unreadable, longer.
[[nodiscard]] Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit);

} // namespace limen::output
