#pragma once

#include "core/Error.h"
#include "dat/Archive.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

// Finds the game's files on a user's disk.
namespace limen::engine {

/// One of the four files and its use.
struct DatFileFact {
    const char* name;
    bool isRequired;
    const char* use; ///< a noun phrase: the content that a world loses without the file
};
/// All four: portal, cell, highres, local.
[[nodiscard]] std::span<const DatFileFact> datFileFacts();

/// A directory with both required files.
struct DatDirectory {
    std::filesystem::path directory;
    dat::ArchivePaths paths;
    std::vector<std::string> absent; ///< names of optional files that it lacks
};

/// Finds the directory for a path that a user gave: the directory itself, one of its files, or a directory up
/// to two levels above it. Names match in any mix of upper and lower case, as on Windows. Reads no file.
/// Errors: NotFound with one line that names each required file, each directory tried and the optional
/// files; Unsupported for files from before the end of retail.
[[nodiscard]] Result<DatDirectory> findDatDirectory(const std::filesystem::path& path);

/// Access to a system, so that a search can be tested.
struct SystemView {
    std::filesystem::path home;
    std::function<std::string(const char*)> environment; ///< "" for an unset variable
    /// The entries of a directory in ascending order; empty if it cannot be read.
    std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> entries;
    std::function<bool(const std::filesystem::path&)> exists;
    std::vector<std::filesystem::path> drives; ///< roots of disks; none on systems without drive letters
};

/// The directories that installers of the game use, on every drive and in the user's Wine prefixes (Wine, Lutris,
/// Bottles, Steam, PlayOnLinux). Only directories that exist, in order of likelihood, each once.
[[nodiscard]] std::vector<std::filesystem::path> knownGameDirectories(const SystemView& system);
/// The same on this system.
[[nodiscard]] std::vector<std::filesystem::path> knownGameDirectories();

} // namespace limen::engine
