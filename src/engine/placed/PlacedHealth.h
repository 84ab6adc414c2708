#pragma once

#include "engine/placed/PlacedObjects.h"

#include <functional>

namespace limen::engine {

/// The visible objects of a world.db, compared with dat files.
struct PlacedHealth {
    std::size_t visible = 0;   ///< objects that stand at the start and are drawn
    std::size_t doors = 0;     ///< of them
    std::size_t hungDoors = 0; ///< doors that have an opening
    /// Names of objects that are not as their rows say, by reason.
    std::map<std::string, std::vector<std::string>> unresolved;
};

/// Reports the part that is done: 0..total landblocks. False cancels.
using HealthProgress = std::function<bool(std::size_t done, std::size_t total)>;

/// Compares all landblocks. Blocks with doors are loaded. Errors: a damaged database; a block that cannot be loaded;
/// `progress` cancelled. Cost: some milliseconds for each landblock with doors.
[[nodiscard]] Result<PlacedHealth> placedHealth(const PlacedObjects& placed, const dat::Archive& archive,
                                                const HealthProgress& progress = {});

} // namespace limen::engine
