#include "world/Nearby.h"

#include "core/Assert.h"
#include "world/Loader.h"

#include <algorithm>

namespace limen::world {

std::vector<dat::BlockCoord> blocksAround(dat::BlockCoord centre, int radius) {
    LIMEN_ASSERT(radius >= 0 && radius <= kMapSize, "a number of blocks on the map");
    std::vector<dat::BlockCoord> blocks;
    for (int x = std::max(centre.x - radius, 0); x <= std::min(centre.x + radius, kMapSize - 1); ++x)
        for (int y = std::max(centre.y - radius, 0); y <= std::min(centre.y + radius, kMapSize - 1); ++y)
            blocks.push_back({x, y});
    return blocks;
}

Result<std::unique_ptr<dat::Region>> loadRegion(const dat::Archive& archive,
                                                std::span<const dat::BlockCoord> blocks) {
    if (!archive.contains<dat::Region>(dat::kRegionId))
        return nullptr;
    Result<dat::Region> region = archive.load<dat::Region>(dat::kRegionId);
    if (region)
        return std::make_unique<dat::Region>(std::move(*region));
    const bool needed = std::any_of(blocks.begin(), blocks.end(), [&](dat::BlockCoord coord) {
        return archive.contains<dat::LandBlock>(dat::landBlockId(coord)) && !isDungeon(archive, coord);
    });
    if (needed)
        return Failure(region.error());
    return nullptr;
}

} // namespace limen::world
