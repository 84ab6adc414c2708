#pragma once

#include "world/LoadCache.h"
#include "world/Loader.h"

namespace limen::world {

/// Yields blocks: kept ones, else built on several threads, each with records and models of its own, and kept.
class BlockSource {
public:
    /// How many are best asked for at once: all threads are busy, and not all of a load's blocks are there twice.
    static constexpr std::size_t kBatch = 32;

    /// All outlive the object. `region`, `detail`: as of BlockBuilder and Models.
    BlockSource(const dat::Archive& archive, const dat::Region* region, double detail, const LoadHelp& help);
    ~BlockSource();
    BlockSource(const BlockSource&) = delete;
    BlockSource& operator=(const BlockSource&) = delete;

    /// By key; null where the archive has nothing of a block. The same whoever builds which.
    [[nodiscard]] std::vector<std::shared_ptr<const BlockContent>> build(std::span<const BlockKey> keys);

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
