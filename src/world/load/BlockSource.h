#pragma once

#include "world/Loader.h"
#include "world/load/LoadCache.h"

namespace limen::world {

/// Yields blocks from the cache. Other blocks are read on several threads, each with its own Records and
/// Models, and added to the cache.
class BlockSource {
public:
    /// The best number of blocks for one call: enough to keep all threads busy, and few enough that a load
    /// does not hold all its blocks twice.
    static constexpr std::size_t kBatch = 32;

    /// All arguments outlive the object. `region` as in BlockReader, `levels` as in Models.
    BlockSource(const dat::Archive& archive, const dat::Region* region, const LevelLimits& levels,
                const LoadHelp& help);
    ~BlockSource();
    BlockSource(const BlockSource&) = delete;
    BlockSource& operator=(const BlockSource&) = delete;

    /// One block for each key; null if the archive has no record of it. The result does not depend on the
    /// threads.
    [[nodiscard]] std::vector<std::shared_ptr<const BlockContent>> read(std::span<const BlockKey> keys);

private:
    struct Worker;
    [[nodiscard]] std::shared_ptr<const BlockContent> find(const BlockKey& key) const;
    [[nodiscard]] std::shared_ptr<const BlockContent> keep(const BlockKey& key, BlockContent&& block) const;

    const dat::Archive& archive_;
    const dat::Region* region_;
    LoadHelp help_;
    std::vector<std::unique_ptr<Worker>> workers_;
};

} // namespace limen::world
