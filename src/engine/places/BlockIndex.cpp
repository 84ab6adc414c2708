#include "engine/places/BlockIndex.h"

#include "engine/places/Shapes.h"
#include "world/World.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limen::engine {
namespace {

constexpr std::size_t kNoBlock = ~std::size_t{0};
constexpr int kTownReach = 2; // blocks each way around a town's main block

void readBuildings(const dat::Archive& archive, BlockFacts& facts) {
    const auto info = archive.load<dat::LandBlockInfo>(dat::landBlockInfoId(facts.coord));
    if (!info)
        return;
    for (const dat::Building& building : info->buildings) {
        const Vec3 at(building.frame.origin);
        if (!isFinite(at))
            continue;
        facts.middle += originOf(facts.coord) + at;
        facts.doors += static_cast<std::uint32_t>(building.portals.size());
        ++facts.buildings;
    }
    if (facts.buildings > 0)
        facts.middle /= static_cast<double>(facts.buildings);
}

/// Index of BlockFacts by position on the map.
using BlockMap = std::vector<std::size_t>;
std::size_t slotOf(dat::BlockCoord coord) {
    return static_cast<std::size_t>(coord.x) * 256 + static_cast<std::size_t>(coord.y);
}

/// Moves `seed` and all built blocks that are connected with it, and near it, from `free` to a town.
Town gather(const std::vector<BlockFacts>& blocks, std::size_t seed, BlockMap& free) {
    Town town;
    town.blocks.push_back(seed);
    free[slotOf(blocks[seed].coord)] = kNoBlock;
    const dat::BlockCoord main = blocks[seed].coord;
    for (std::size_t next = 0; next < town.blocks.size(); ++next) {
        const dat::BlockCoord at = blocks[town.blocks[next]].coord;
        for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, 255); ++x) {
            for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, 255); ++y) {
                std::size_t& other = free[slotOf({x, y})];
                if (other == kNoBlock || std::abs(x - main.x) > kTownReach ||
                    std::abs(y - main.y) > kTownReach)
                    continue;
                town.blocks.push_back(other);
                other = kNoBlock;
            }
        }
    }
    for (const std::size_t block : town.blocks) {
        town.buildings += blocks[block].buildings;
        town.middle += blocks[block].middle * static_cast<double>(blocks[block].buildings);
    }
    town.middle /= static_cast<double>(town.buildings);
    return town;
}

} // namespace

Result<std::vector<BlockFacts>> readBlockIndex(const dat::Archive& archive) {
    std::vector<BlockFacts> blocks;
    std::vector<std::size_t> withInfo;
    const Result<void> read = archive.cell().forEach([&](const dat::Entry& entry) {
        if (entry.id == dat::kIterationId)
            return true;
        const dat::BlockCoord coord = dat::blockOf(entry.id);
        if (blocks.empty() || !(blocks.back().coord == coord))
            blocks.push_back({coord, false, 0, 0, 0, 0, Vec3(0.0)});
        BlockFacts& facts = blocks.back();
        const std::uint32_t low = entry.id & 0xFFFFu;
        if (low == 0xFFFFu) {
            facts.hasLand = true;
        } else if (low == 0xFFFEu) {
            withInfo.push_back(blocks.size() - 1);
        } else if (low >= dat::kFirstCell) {
            facts.firstCell = facts.cells == 0 ? entry.id : facts.firstCell;
            ++facts.cells;
        }
        return true;
    });
    if (!read)
        return Failure(read.error());
    for (const std::size_t block : withInfo)
        readBuildings(archive, blocks[block]);
    return blocks;
}

std::vector<Town> findTowns(const std::vector<BlockFacts>& blocks) {
    BlockMap free(std::size_t{256} * 256, kNoBlock);
    std::vector<std::size_t> built;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i].buildings == 0)
            continue;
        built.push_back(i);
        free[slotOf(blocks[i].coord)] = i;
    }
    std::stable_sort(built.begin(), built.end(),
                     [&](std::size_t a, std::size_t b) { return blocks[a].buildings > blocks[b].buildings; });
    std::vector<Town> towns;
    for (const std::size_t seed : built)
        if (free[slotOf(blocks[seed].coord)] != kNoBlock)
            towns.push_back(gather(blocks, seed, free));
    std::stable_sort(towns.begin(), towns.end(),
                     [](const Town& a, const Town& b) { return a.buildings > b.buildings; });
    return towns;
}

Vec3 middleOfLand(const std::vector<BlockFacts>& blocks) {
    Vec3 sum(0.0);
    double count = 0.0;
    for (const BlockFacts& block : blocks) {
        if (!block.hasLand)
            continue;
        sum += originOf(block.coord) + Vec3(world::kBlockSize * 0.5, world::kBlockSize * 0.5, 0.0);
        count += 1.0;
    }
    const double middle = world::kMapSize * world::kBlockSize * 0.5;
    return count > 0.0 ? sum / count : Vec3(middle, middle, 0.0);
}

} // namespace limen::engine
