#pragma once

#include "output/Picture.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace limen::output {

/// Tests whether a file can be written at `path`: makes a file beside it and removes that again. An existing
/// file is not touched. Errors: the directory is missing or not writable; `path` is a directory or
/// write-protected.
[[nodiscard]] Result<void> checkWritable(const std::filesystem::path& path);

/// Writes a file beside its place and then renames it, so that no program ever reads half a file. Devices and
/// pipes (/dev/null) are written directly. Errors: as checkWritable; a full disk.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view text);

/// Tests whether a picture can be written at `path`. Errors: an ending that names no picture format; as
/// checkWritable.
[[nodiscard]] Result<void> checkPictureWritable(const std::filesystem::path& path);

/// Writes a picture in the format that the file name's ending selects; pipes and devices get PNG. Errors: an
/// ending that names no picture format; as writeFile; those of the encoder.
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& path, const Picture& picture);

/// Makes a directory and its parents if they are missing. Errors: it cannot be made; a file has that name.
[[nodiscard]] Result<void> makeDirectory(const std::filesystem::path& path);

/// Reads a text file of at most `limit` bytes. Errors: missing, unreadable, longer.
[[nodiscard]] Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit);

} // namespace limen::output
