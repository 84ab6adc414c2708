#include "world/Loader.h"

#include "core/Assert.h"
#include "world/Nearby.h"
#include "world/assemble/AssembleWorld.h"
#include "world/block/BlockReader.h"
#include "world/load/BlockSource.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Reads a list of blocks batch by batch and yields those that exist, in the order of their keys.
class BlockStream {
public:
    BlockStream(BlockSource& source, std::vector<BlockKey> keys) : source_(source), keys_(std::move(keys)) {
        LIMEN_ASSERT(std::is_sorted(keys_.begin(), keys_.end()), "blocks are joined in ascending order");
    }

    /// Null after the last block.
    [[nodiscard]] std::shared_ptr<const BlockContent> next() {
        for (;;) {
            if (position_ == batch_.size() && !readBatch())
                return nullptr;
            if (std::shared_ptr<const BlockContent> block = std::move(batch_[position_++]))
                return block;
        }
    }

private:
    [[nodiscard]] bool readBatch() {
        const std::size_t count = std::min(BlockSource::kBatch, keys_.size() - read_);
        batch_ = source_.read(std::span(keys_).subspan(read_, count));
        LIMEN_ASSERT(batch_.size() == count, "one entry for each key");
        read_ += count;
        position_ = 0;
        return count > 0;
    }

    BlockSource& source_;
    std::vector<BlockKey> keys_;
    std::size_t read_ = 0; ///< keys whose blocks are read
    std::vector<std::shared_ptr<const BlockContent>> batch_;
    std::size_t position_ = 0; ///< in batch_
};

} // namespace

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
        return Failure(region.error());
    const LevelLimits levels{options.detail, options.readings.levelBias};
    std::vector<BlockKey> keys;
    for (const dat::BlockCoord block : blocks) {
        const int away = std::max(std::abs(block.x - centre.x), std::abs(block.y - centre.y));
        keys.push_back(
            {block.x, block.y, away > radius ? Tier::Far : Tier::Near, options.mergeZones, levels});
    }
    if (help.progress != nullptr)
        help.progress->blocks = keys.size();
    BlockSource source(archive, region->get(), levels, help);
    BlockStream stream(source, std::move(keys));
    Records records(archive);
    Models models(records, levels, help.cache != nullptr ? &help.cache->models : nullptr);
    PictureCache* const pictures = help.cache != nullptr ? &help.cache->pictures : nullptr;
    World world = assembleWorld(
        {records, models, region->get(), pictures, options.readings}, [&stream] { return stream.next(); },
        moving);
    if (help.progress != nullptr && help.progress->isCancelled)
        return fail(ErrorCode::Unreadable, archive.directory().string(), "loading was cancelled");
    if (world.blocks.empty())
        return fail(ErrorCode::NotFound, archive.directory().string(),
                    "no landblock is near this place; choose another place with --at");
    return world;
}

} // namespace limen::world
