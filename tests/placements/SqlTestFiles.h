#pragma once

#include "placements/ExportSql.h"
#include "support/TemporaryDirectory.h"

namespace limen::test {

inline void putSql(const std::filesystem::path& directory, const placements::SqlText& file) {
    std::filesystem::create_directories((directory / file.path).parent_path());
    putText(directory / file.path, file.text);
}

/// Writes a content as files of SQL.
inline void putContent(const std::filesystem::path& directory, const placements::Content& content) {
    for (const auto& [id, landblock] : content.landblocks)
        putSql(directory, placements::sqlOf(id, landblock));
    for (const auto& [id, of] : content.templates)
        putSql(directory, placements::sqlOf(of));
}

} // namespace limen::test
