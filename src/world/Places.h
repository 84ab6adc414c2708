#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "geometry/Vec.h"
#include "world/MovingEntries.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limen::world {

/// A named viewpoint.
struct Place {
    std::string name;
    Vec3 eye{0.0};          ///< global
    double yaw = 0.0;       ///< degrees, 0 north, 90 east
    double pitch = 0.0;     ///< degrees, positive up
    dat::RecordId cell = 0; ///< the cell that contains the eye; 0: outside
};

/// True if the way between two successive way points is no line: one of them is in a cell whose block is not
/// that of the other point nor next to it. No line leads into a dungeon.
[[nodiscard]] bool isJump(const Place& from, const Place& to);

inline constexpr const char* kWorldFileName = "world.json";

/// The content of `world.json`, which is in the directory of the .dat files. All of it is optional.
struct WorldFile {
    std::vector<Place> places;
    std::string start;       ///< name of the initial place; empty: none
    std::vector<Place> tour; ///< way points, joined by straight lines
    MovingEntries moving;
};

/// Reads `directory/world.json`; an absent file gives an empty WorldFile. Errors: the file cannot be read, or
/// an entry is malformed (docs/world-file.md).
[[nodiscard]] Result<WorldFile> loadWorldFile(const std::filesystem::path& directory);
/// Reads the text of such a file. `file`: its name, for error messages.
[[nodiscard]] Result<WorldFile> parseWorldFile(const std::string& text, const std::string& file);

} // namespace limen::world
