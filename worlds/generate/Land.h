#pragma once

#include "dat/Ids.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/records/WorldRecords.h"

#include <functional>

namespace limen::worlds {

/// The ground of a generated world: a rectangle of landblocks. Heights are indices of the Region's table.
class Land {
public:
    Land(dat::BlockCoord southWest, int blocksX, int blocksY, int heightIndex);

    /// Vertices count from the south-west corner; they are 24 m apart.
    [[nodiscard]] int verticesX() const { return verticesX_; }
    [[nodiscard]] int verticesY() const { return verticesY_; }
    void setHeight(int vx, int vy, int heightIndex);
    [[nodiscard]] int heightIndexAt(int vx, int vy) const;
    void setCover(int vx, int vy, TerrainKind kind, bool road, std::uint32_t scenery = 0);

    /// The height (metres) of the ground's triangle at a point in metres from the south-west corner.
    [[nodiscard]] double heightAt(double x, double y) const;

    [[nodiscard]] dat::BlockCoord blockAt(int bx, int by) const {
        return {southWest_.x + bx, southWest_.y + by};
    }
    /// Adds all LandBlocks, marked as having a LandBlockInfo.
    void addTo(WorldRecords& records) const;
    /// Adds the LandBlocks for which `isLand(column, row)` holds, counted from the south-west. Those are
    /// marked as having a LandBlockInfo for which the records hold one.
    void addTo(WorldRecords& records, const std::function<bool(int, int)>& isLand) const;

private:
    [[nodiscard]] std::size_t indexOf(int vx, int vy) const;
    [[nodiscard]] bool splitsSouthWest(int cx, int cy) const;
    [[nodiscard]] dat::LandBlock recordOf(int bx, int by) const;

    dat::BlockCoord southWest_;
    int blocksX_, blocksY_, verticesX_, verticesY_;
    std::vector<std::uint8_t> heights_;
    std::vector<std::uint16_t> words_;
};

} // namespace limen::worlds
