#pragma once

#include "dat/Archive.h"
#include "doctor/Finding.h"

#include <array>
#include <filesystem>
#include <functional>
#include <optional>

// Whether dat files are whole, without decoding all of their records.
namespace limen::doctor {

/// Records of an index that cannot be where it says.
struct StrayEntries {
    std::uint64_t count = 0;
    dat::Entry first;
};

/// One dat file, examined.
struct FileHealth {
    std::filesystem::path path;
    dat::FileRole role = dat::FileRole::Portal; ///< the expected one
    bool isRequired = true, exists = false;
    std::optional<dat::File> file; ///< the opened file
    std::optional<Error> error;    ///< the reason why the file cannot be opened, or its index not be walked
    std::array<std::uint64_t, static_cast<std::size_t>(dat::RecordKind::Other) + 1> byKind{};
    std::uint64_t records = 0, compressed = 0;
    dat::IndexShape shape;
    StrayEntries strays;
    dat::FreeList freeList;
    std::vector<std::string> warnings;

    [[nodiscard]] bool isSound() const { return file && !error && strays.count == 0; }
};

/// Opens a file, walks its index and its free list. A missing file gives a result without `file` and `error`.
[[nodiscard]] FileHealth examineFile(const std::filesystem::path& path, dat::FileRole role, bool isRequired);
/// The check of the file, and those of its index, its free list and its release.
[[nodiscard]] Findings judgeFile(const FileHealth& health);
/// The name of a role in tables: "portal", "cell", "highres", "local".
[[nodiscard]] const char* roleName(dat::FileRole role);

/// The four files of a directory: portal, cell, highres, local.
[[nodiscard]] std::vector<FileHealth> examineDirectory(const std::filesystem::path& directory);
/// The files at these paths. An optional file without a path is missing.
[[nodiscard]] std::vector<FileHealth> examineFiles(const dat::ArchivePaths& paths);

} // namespace limen::doctor
