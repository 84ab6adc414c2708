#pragma once

#include "dat/Archive.h"
#include "dat/records/Landscape.h"

#include "world/World.h"

#include <memory>
#include <span>
#include <vector>

// The blocks around a place, and the Region they need.
namespace limen::world {

/// The blocks at most `radius` blocks away along each axis, in ascending order of (x, y).
[[nodiscard]] std::vector<dat::BlockCoord> blocksAround(dat::BlockCoord centre, int radius);

/// The Region, or null if the archive has none. Errors: it cannot be read although a block needs it.
[[nodiscard]] Result<std::unique_ptr<dat::Region>> loadRegion(const dat::Archive& archive,
                                                              std::span<const dat::BlockCoord> blocks);

} // namespace limen::world
