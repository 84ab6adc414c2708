#pragma once

#include "core/Error.h"

#include <cstdint>
#include <filesystem>

namespace limen::bench {

/// The size of the published world database.
struct PlacedCounts {
    std::uint32_t objects = 365'183, templates = 44'000, landblocks = 4'520;
    std::uint32_t generators = 201'291, doors = 26'348, people = 76'743, portals = 4'530;
};

/// Writes a world.db of made-up objects beside dat files: a part of them in towns, in dungeons and on open land, with links from
/// generators to the objects that they stand for. Doors stand in openings. Equal files give equal objects. Errors: the files
/// cannot be read; they have no models or no cells; the database cannot be written.
[[nodiscard]] Result<void> writeFullWorld(const std::filesystem::path& dats, const PlacedCounts& counts = {});

} // namespace limen::bench
