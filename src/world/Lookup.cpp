#include "world/Lookup.h"

#include "core/Assert.h"
#include "world/Ground.h"

#include <cmath>
#include <limits>

namespace limen::world {

SpaceIndex findCell(const World& world, dat::RecordId cellId) {
    LIMEN_ASSERT(world.spaces.empty() || world.spaces[kOutside].cellId == 0,
                 "the outside is the first space");
    // Cells are in ascending order of id: blocks are, and a block's cells are.
    const auto begin = world.spaces.begin() + std::min<std::ptrdiff_t>(1, std::ssize(world.spaces));
    const auto found =
        std::lower_bound(begin, world.spaces.end(), cellId,
                         [](const Space& space, dat::RecordId id) { return space.cellId < id; });
    return found != world.spaces.end() && found->cellId == cellId
               ? static_cast<SpaceIndex>(found - world.spaces.begin())
               : kNone;
}

const Block* findBlock(const World& world, dat::BlockCoord coord) {
    const auto before = [](const Block& block, dat::BlockCoord c) {
        return block.coord.x != c.x ? block.coord.x < c.x : block.coord.y < c.y;
    };
    const auto found = std::lower_bound(world.blocks.begin(), world.blocks.end(), coord, before);
    return found != world.blocks.end() && found->coord == coord ? &*found : nullptr;
}

dat::BlockCoord blockAt(const Vec3& position) {
    const auto clamped = [](double v) {
        const double block = std::floor(v / kBlockSize);
        return block > 0.0 ? static_cast<int>(std::min(block, kMapSize - 1.0)) : 0;
    };
    return {clamped(position.x), clamped(position.y)};
}

double metresBeside(dat::BlockCoord block, const Vec3& position) {
    const Vec3 local = position - Vec3(block.x, block.y, 0.0) * kBlockSize;
    return std::max({-local.x, local.x - kBlockSize, -local.y, local.y - kBlockSize, 0.0});
}

double terrainHeight(const World& world, double x, double y) {
    const Block* block = findBlock(world, blockAt({x, y, 0.0}));
    if (block == nullptr || !block->hasTerrain)
        return std::numeric_limits<double>::quiet_NaN();
    const Vec3 origin = block->origin();
    if (x < origin.x || y < origin.y || x > origin.x + kBlockSize || y > origin.y + kBlockSize)
        return std::numeric_limits<double>::quiet_NaN();
    return groundAt(block->coord, block->heights, x - origin.x, y - origin.y).z;
}

} // namespace limen::world
