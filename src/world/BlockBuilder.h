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
    /// The same, of the ground alone. No value if there is none.
    [[nodiscard]] std::optional<BlockContent> buildFar(dat::BlockCoord coord);

private:
    [[nodiscard]] std::optional<BlockContent> read(dat::BlockCoord coord);
    [[nodiscard]] std::optional<BlockContent> readFar(dat::BlockCoord coord);
    void addTerrain(const dat::LandBlock& record, BlockContent& block);
    void buildCells(const dat::LandBlockInfo& info, BlockContent& block);
    void buildGround(const dat::LandBlock& record, const dat::LandBlockInfo* info, BlockContent& block);
    void placeObjects(const dat::LandBlockInfo& info, BlockContent& block);
    /// Of any vertex of the landscape that a block has; global indices, not negative.
    [[nodiscard]] std::optional<float> heightAt(int globalX, int globalY);
    [[nodiscard]] const std::optional<dat::LandBlock>& neighbour(dat::BlockCoord coord);

    Records& records_;
    Models& models_;
    const dat::Region* region_;
    bool mergeZones_;
    std::unordered_map<dat::RecordId, std::optional<dat::LandBlock>> neighbours_;
};

/// True for blocks without any ground (docs/ray-rule.md): all heights 0, cells, no buildings.
[[nodiscard]] bool isPureDungeon(const dat::LandBlock& land, const dat::LandBlockInfo* info);

} // namespace limen::world
