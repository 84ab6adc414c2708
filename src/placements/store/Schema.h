#pragma once

#include <cstdint>

namespace limen::placements {

/// Marks a SQLite file as a world.db of Limen ("LIMW"), as PRAGMA application_id.
inline constexpr std::int64_t kApplicationId = 0x4C494D57;
/// The version of the tables below, as PRAGMA user_version. A file of another version is written again.
inline constexpr std::int64_t kSchemaVersion = 2;

/// The tables of world.db (docs/placements.md).
extern const char* const kSchema;

} // namespace limen::placements
