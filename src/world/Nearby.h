#pragma once

#include "dat/Archive.h"
#include "dat/records/Landscape.h"

#include <memory>
#include <span>
#include <vector>

// What everything that is loaded around a place begins with.
namespace limen::world {

inline constexpr int kMapSize = 255; ///< blocks each way

/// The blocks up to `radius` away each way, ascending by (x, y).
[[nodiscard]] std::vector<dat::BlockCoord> blocksAround(dat::BlockCoord centre, int radius);

/// The Region, null if the world has none. Errors: it is there and cannot be read although some block needs it.
[[nodiscard]] Result<std::unique_ptr<dat::Region>> loadRegion(const dat::Archive& archive,
                                                              std::span<const dat::BlockCoord> blocks);

} // namespace limen::world
