#include "worlds/generate/Land.h"

#include <algorithm>
#include <set>

namespace limen::worlds {

Land::Land(dat::BlockCoord southWest, int blocksX, int blocksY, int heightIndex)
    : southWest_(southWest), blocksX_(blocksX), blocksY_(blocksY), verticesX_(blocksX * kCellsPerBlock + 1),
      verticesY_(blocksY * kCellsPerBlock + 1),
      heights_(static_cast<std::size_t>(verticesX_ * verticesY_), static_cast<std::uint8_t>(heightIndex)),
      words_(heights_.size(),
             static_cast<std::uint16_t>(static_cast<std::uint32_t>(TerrainKind::Grassland) << 2)) {}

std::size_t Land::indexOf(int vx, int vy) const {
    return static_cast<std::size_t>(vx * verticesY_ + vy);
}

void Land::setHeight(int vx, int vy, int heightIndex) {
    if (vx >= 0 && vy >= 0 && vx < verticesX_ && vy < verticesY_)
        heights_[indexOf(vx, vy)] = static_cast<std::uint8_t>(std::clamp(heightIndex, 1, 255));
}

int Land::heightIndexAt(int vx, int vy) const {
    return heights_[indexOf(std::clamp(vx, 0, verticesX_ - 1), std::clamp(vy, 0, verticesY_ - 1))];
}

void Land::setCover(int vx, int vy, TerrainKind kind, bool road, std::uint32_t scenery) {
    if (vx >= 0 && vy >= 0 && vx < verticesX_ && vy < verticesY_) {
        words_[indexOf(vx, vy)] = static_cast<std::uint16_t>(
            (road ? 1u : 0u) | static_cast<std::uint32_t>(kind) << 2 | scenery << 11);
    }
}

// docs/formats/landscape.md#triangles: true if the landcell's diagonal runs from south-west to north-east.
bool Land::splitsSouthWest(int cx, int cy) const {
    const auto x = static_cast<std::uint32_t>(southWest_.x * kCellsPerBlock + cx);
    const auto y = static_cast<std::uint32_t>(southWest_.y * kCellsPerBlock + cy);
    return x * y * 0x0CCAC033u + y * 0x6C1AC587u - x * 0x421BE3BDu - 0x519B8F25u >= 0x80000000u;
}

double Land::heightAt(double x, double y) const {
    const int cx = std::clamp(static_cast<int>(std::floor(x / kLandcell)), 0, verticesX_ - 2);
    const int cy = std::clamp(static_cast<int>(std::floor(y / kLandcell)), 0, verticesY_ - 2);
    const double fx = x / kLandcell - cx;
    const double fy = y / kLandcell - cy;
    const auto z = [&](int vx, int vy) { return heightOfIndex(heightIndexAt(vx, vy)); };
    const double sw = z(cx, cy), se = z(cx + 1, cy), ne = z(cx + 1, cy + 1), nw = z(cx, cy + 1);
    if (splitsSouthWest(cx, cy))
        return fx >= fy ? sw + (se - sw) * fx + (ne - se) * fy : sw + (ne - nw) * fx + (nw - sw) * fy;
    return fx + fy <= 1.0 ? sw + (se - sw) * fx + (nw - sw) * fy
                          : ne + (nw - ne) * (1.0 - fx) + (se - ne) * (1.0 - fy);
}

dat::LandBlock Land::recordOf(int bx, int by) const {
    dat::LandBlock block;
    block.id = dat::landBlockId(blockAt(bx, by));
    for (int x = 0; x <= kCellsPerBlock; ++x) {
        for (int y = 0; y <= kCellsPerBlock; ++y) {
            const auto at = static_cast<std::size_t>(x * (kCellsPerBlock + 1) + y);
            const std::size_t from = indexOf(bx * kCellsPerBlock + x, by * kCellsPerBlock + y);
            block.heights[at] = heights_[from];
            block.terrain[at] = words_[from];
        }
    }
    return block;
}

void Land::addTo(WorldRecords& records) const {
    for (int bx = 0; bx < blocksX_; ++bx) {
        for (int by = 0; by < blocksY_; ++by) {
            records.landBlocks.push_back(recordOf(bx, by));
            records.landBlocks.back().hasObjects = 1;
        }
    }
}

void Land::addTo(WorldRecords& records, const std::function<bool(int, int)>& isLand) const {
    std::set<dat::RecordId> known;
    for (const dat::LandBlockInfo& info : records.landBlockInfos)
        known.insert(info.id);
    for (int bx = 0; bx < blocksX_; ++bx) {
        for (int by = 0; by < blocksY_; ++by) {
            if (isLand(bx, by)) {
                records.landBlocks.push_back(recordOf(bx, by));
                records.landBlocks.back().hasObjects =
                    known.contains(dat::landBlockInfoId(blockAt(bx, by))) ? 1 : 0;
            }
        }
    }
}

} // namespace limen::worlds
