#pragma once

#include "world/BlockContent.h"

namespace limen::world {

/// Builds the content of single landblocks from records. Blocks are independent of each other: one builder
/// (with Records and Models of its own) a thread can build them in any order.
class BlockBuilder {
public:
    /// `region`: null if the world has none; then blocks have no terrain. All outlive the builder.
    BlockBuilder(Records& records, Models& models, const dat::Region* region, bool mergeZones)
        : records_(records), models_(models), region_(region), mergeZones_(mergeZones) {}

    /// No value if the cell file holds nothing of this block. Damage is said in the content's findings: a
    /// record that cannot be read is left out.
    [[nodiscard]] std::optional<BlockContent> build(dat::BlockCoord coord);

private:
    void buildCells(const dat::LandBlockInfo& info, BlockContent& block);
    void buildGround(const dat::LandBlock& record, const dat::LandBlockInfo* info, BlockContent& block);
    void placeObjects(const dat::LandBlockInfo& info, BlockContent& block);
    [[nodiscard]] std::optional<float> heightAt(int globalX, int globalY);

    Records& records_;
    Models& models_;
    const dat::Region* region_;
    bool mergeZones_;
    std::unordered_map<dat::RecordId, std::optional<dat::LandBlock>> neighbours_;
};

/// True for blocks without any ground (docs/ray-rule.md): all heights 0, cells, no buildings.
[[nodiscard]] bool isPureDungeon(const dat::LandBlock& land, const dat::LandBlockInfo* info);

} // namespace limen::world
