#pragma once

#include "dat/File.h"

#include <array>
#include <string>

// Known releases of the original files, recognised by header fields and numbers of records.
namespace limen::doctor {

/// The figures of a file that identify its release.
struct FileIdentity {
    dat::FileRole role = dat::FileRole::Portal;
    std::uint32_t engineVersion = 0, minorVersion = 0;
    std::array<std::uint8_t, 16> majorVersion{};
    std::uint64_t length = 0;  ///< bytes
    std::uint64_t records = 0; ///< 0: not counted
};

enum class Release : std::uint8_t {
    EndOfRetail,        ///< all figures are those of the last original files
    EndOfRetailChanged, ///< versions and GUID of the last original files; size or number of records differs
    Unknown             ///< any other world; no fault
};

[[nodiscard]] FileIdentity identityOf(const dat::File& file, std::uint64_t records);
/// The release of one file. An uncounted number of records is not compared.
[[nodiscard]] Release releaseOf(const FileIdentity& file);
/// The release of two files of one world: the less original of both.
[[nodiscard]] Release releaseOf(const FileIdentity& portal, const FileIdentity& cell);
[[nodiscard]] std::string nameOf(Release release);

} // namespace limen::doctor
