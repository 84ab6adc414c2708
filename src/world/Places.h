#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "geometry/Vec.h"
#include "world/MovingEntries.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limen::world {

/// A named standing eye.
struct Place {
    std::string name;
    Vec3 eye{0.0};          ///< global
    double yaw = 0.0;       ///< degrees, 0 north, 90 east
    double pitch = 0.0;     ///< degrees, positive up
    dat::RecordId cell = 0; ///< 0: outside
};

inline constexpr const char* kWorldFileName = "world.json";

/// What `world.json` beside the dats says; everything is optional.
struct WorldFile {
    std::vector<Place> places;
    std::string start;       ///< the one of `places` to begin at; empty: none is named
    std::vector<Place> tour; ///< way points, walked in straight lines
    MovingEntries moving;
};

/// Reads `directory/world.json`; an absent file gives an empty WorldFile. Errors: unreadable or not of this
/// shape.
[[nodiscard]] Result<WorldFile> loadWorldFile(const std::filesystem::path& directory);
/// Its text; `file` begins messages.
[[nodiscard]] Result<WorldFile> parseWorldFile(const std::string& text, const std::string& file);

} // namespace limen::world
