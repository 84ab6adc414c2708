#include "world/Loader.h"

#include "world/Assembly.h"
#include "world/BlockBuilder.h"
#include "world/BlockSource.h"
#include "world/Nearby.h"

#include <algorithm>

namespace limen::world {

bool isDungeon(const dat::Archive& archive, dat::BlockCoord coord) {
    const Result<dat::LandBlock> land = archive.load<dat::LandBlock>(dat::landBlockId(coord));
    const Result<dat::LandBlockInfo> info = archive.load<dat::LandBlockInfo>(dat::landBlockInfoId(coord));
    return land && info && isPureDungeon(*land, &*info);
}

Result<World> loadWorld(const dat::Archive& archive, dat::BlockCoord centre, const LoadOptions& options,
                        const MovingEntries& moving, const LoadHelp& help) {
    if (centre.x < 0 || centre.y < 0 || centre.x >= kMapSize || centre.y >= kMapSize || options.radius < 0)
        return fail(ErrorCode::BadArgument, archive.directory().string(),
                    "no landblock there: blocks run from 0 to 254");
    const bool isSealed = isDungeon(archive, centre);
    const int radius = isSealed ? 0 : std::min(options.radius, kMapSize);
    const int farRadius = isSealed ? 0 : std::min(options.farRadius, kMapSize);
    const std::vector<dat::BlockCoord> blocks = blocksAround(centre, std::max(radius, farRadius));
    Result<std::unique_ptr<dat::Region>> region = loadRegion(archive, blocks);
    if (!region)
        return tl::unexpected(region.error());
    const auto keyOf = [&](dat::BlockCoord block) {
        const int away = std::max(std::abs(block.x - centre.x), std::abs(block.y - centre.y));
        return BlockKey{block.x, block.y, away > radius ? Tier::Far : Tier::Near, options.mergeZones,
                        options.detail};
    };
    BlockSource source(archive, region->get(), options.detail, help);
    Records records(archive);
    Models models(records, options.detail, help.cache);
    Assembly assembly(records, models, region->get(), help.cache);
    bool any = false;
    for (std::size_t done = 0; done < blocks.size(); done += BlockSource::kBatch) {
        const std::size_t end = std::min(done + BlockSource::kBatch, blocks.size());
        std::vector<BlockKey> batch;
        std::transform(blocks.begin() + std::ptrdiff_t(done), blocks.begin() + std::ptrdiff_t(end),
                       std::back_inserter(batch), keyOf);
        for (const std::shared_ptr<const BlockContent>& block : source.build(batch)) {
            if (block != nullptr) {
                assembly.add(*block);
                any = true;
            }
        }
    }
    if (!any)
        return fail(ErrorCode::NotFound, archive.directory().string(),
                    "no landblock around the place asked for");
    return assembly.finish(moving);
}

SpaceIndex findCell(const World& world, dat::RecordId cellId) {
    // Spaces follow their blocks, and those are in the order of their ids.
    const auto begin = world.spaces.begin() + std::min<std::ptrdiff_t>(1, std::ssize(world.spaces));
    const auto found =
        std::lower_bound(begin, world.spaces.end(), cellId,
                         [](const Space& space, dat::RecordId id) { return space.cellId < id; });
    return found != world.spaces.end() && found->cellId == cellId
               ? static_cast<SpaceIndex>(found - world.spaces.begin())
               : kNone;
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

const Block* findBlock(const World& world, dat::BlockCoord coord) {
    const auto before = [](const Block& block, dat::BlockCoord c) {
        return block.coord.x != c.x ? block.coord.x < c.x : block.coord.y < c.y;
    };
    const auto found = std::lower_bound(world.blocks.begin(), world.blocks.end(), coord, before);
    return found != world.blocks.end() && found->coord == coord ? &*found : nullptr;
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
