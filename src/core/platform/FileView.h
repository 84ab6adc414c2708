#pragma once

#include "core/Error.h"

#include <cstddef>
#include <filesystem>

namespace limen::platform {

/// The bytes of a file, mapped into memory for reading. Null and 0 for an empty file.
struct FileView {
    const std::byte* data = nullptr;
    std::size_t size = 0;
};

/// Errors: NotFound; Unreadable, also for a directory or a device.
[[nodiscard]] Result<FileView> mapFile(const std::filesystem::path& path);
/// Requires a view that was mapped and not yet unmapped.
void unmapFile(FileView view);
/// A hint: the pages in memory are not needed soon. Reading them stays possible.
void letPagesGo(FileView view);

} // namespace limen::platform
