#include "world/load/BlockSource.h"

#include "core/Assert.h"
#include "world/block/BlockReader.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace limen::world {

constexpr std::size_t kMostEnvironments = 64; // kept decoded from block to block: about 10 MiB

/// The objects of one thread.
struct BlockSource::Worker {
    Worker(const dat::Archive& archive, const dat::Region* region, const LevelLimits& levels,
           LoadCache* cache)
        : records(archive), models(records, levels, cache != nullptr ? &cache->models : nullptr),
          merged(records, models, region, true), apart(records, models, region, false) {}

    std::optional<BlockContent> read(const BlockKey& key) {
        BlockReader& reader = key.mergeZones ? merged : apart;
        const dat::BlockCoord coord{key.x, key.y};
        records.forgetEnvironments(kMostEnvironments);
        return key.tier == Tier::Near ? reader.read(coord) : reader.readGround(coord);
    }

    Records records;
    Models models;
    BlockReader merged, apart;
};

BlockSource::BlockSource(const dat::Archive& archive, const dat::Region* region, const LevelLimits& levels,
                         const LoadHelp& help)
    : archive_(archive), region_(region), help_(help) {
    for (unsigned i = 0; i < std::max(help.threads, 1u); ++i)
        workers_.push_back(std::make_unique<Worker>(archive_, region_, levels, help_.cache));
}

BlockSource::~BlockSource() = default;

std::shared_ptr<const BlockContent> BlockSource::find(const BlockKey& key) const {
    return help_.cache != nullptr ? help_.cache->blocks.find(key) : nullptr;
}

std::shared_ptr<const BlockContent> BlockSource::keep(const BlockKey& key, BlockContent&& block) const {
    auto shared = std::make_shared<const BlockContent>(std::move(block));
    return help_.cache != nullptr ? help_.cache->blocks.keep(key, shared, bytesOf(*shared)) : shared;
}

std::vector<std::shared_ptr<const BlockContent>> BlockSource::read(std::span<const BlockKey> keys) {
    std::vector<std::shared_ptr<const BlockContent>> blocks(keys.size());
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        blocks[i] = find(keys[i]);
        if (blocks[i] == nullptr)
            missing.push_back(i);
    }
    LIMEN_ASSERT(!workers_.empty(), "this thread has a worker");
    LoadProgress* const progress = help_.progress;
    if (progress != nullptr)
        progress->done += keys.size() - missing.size();
    std::atomic<std::size_t> next = 0;
    const auto work = [&](Worker& worker) {
        for (std::size_t i = next++; i < missing.size(); i = next++) {
            if (progress != nullptr && progress->isCancelled)
                return;
            const BlockKey& key = keys[missing[i]];
            if (std::optional<BlockContent> block = worker.read(key))
                blocks[missing[i]] = keep(key, std::move(*block));
            if (progress != nullptr)
                ++progress->done;
        }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < std::min(workers_.size(), missing.size()); ++i)
        threads.emplace_back([&, i] { work(*workers_[i]); });
    work(*workers_.front());
    for (std::thread& thread : threads)
        thread.join();
    return blocks;
}

} // namespace limen::world
