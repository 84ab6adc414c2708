#pragma once

#include "world/block/BlockContent.h"

namespace limen::world {

/// Reads the content of single landblocks from records. Blocks are independent of each other, so several
/// threads, each with its own reader, Records and Models, can read them in any order.
class BlockReader {
public:
    /// `region`: null if the world has none; then blocks have no terrain. All outlive the reader.
    BlockReader(Records& records, Models& models, const dat::Region* region, bool mergeZones)
        : records_(records), models_(models), region_(region), mergeZones_(mergeZones) {}

    /// Everything. No value if the cell file has no record of this block. Records that cannot be read are
    /// left out, with findings in the content.
    [[nodiscard]] std::optional<BlockContent> read(dat::BlockCoord coord);
    /// The ground alone, for the far tier. No value if there is none.
    [[nodiscard]] std::optional<BlockContent> readGround(dat::BlockCoord coord);

private:
    [[nodiscard]] std::optional<BlockContent> readNear(dat::BlockCoord coord);
    [[nodiscard]] std::optional<BlockContent> readFar(dat::BlockCoord coord);
    void addTerrain(const dat::LandBlock& record, BlockContent& block);
    void addCells(const dat::LandBlockInfo& info, BlockContent& block);
    /// Terrain and scenery.
    void addGround(const dat::LandBlock& record, const dat::LandBlockInfo* info, BlockContent& block);
    void addObjects(const dat::LandBlockInfo& info, BlockContent& block);
    /// The height of a vertex of the map, metres; global indices, not negative. No value if no block has it.
    [[nodiscard]] std::optional<float> heightAt(int globalX, int globalY);
    [[nodiscard]] const std::optional<dat::LandBlock>& neighbour(dat::BlockCoord coord);

    Records& records_;
    Models& models_;
    const dat::Region* region_;
    bool mergeZones_;
    std::unordered_map<dat::RecordId, std::optional<dat::LandBlock>> neighbours_;
};

/// True for blocks without ground (docs/ray-rule.md): all heights are 0, there are cells and no buildings.
[[nodiscard]] bool isPureDungeon(const dat::LandBlock& land, const dat::LandBlockInfo* info);

} // namespace limen::world
