#pragma once

#include "dat/Ids.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/records/WorldRecords.h"

#include <functional>

namespace limen::worlds {

/// The ground of generated worlds: some landblocks, heights by index of the Region's table.
class Land {
public:
    Land(dat::BlockCoord southWest, int blocksX, int blocksY, int heightIndex);

    /// Vertices are counted from the south-west corner, 24 m apart.
    [[nodiscard]] int verticesX() const { return verticesX_; }
    [[nodiscard]] int verticesY() const { return verticesY_; }
    void setHeight(int vx, int vy, int heightIndex);
    [[nodiscard]] int heightIndexAt(int vx, int vy) const;
    void setCover(int vx, int vy, TerrainKind kind, bool road);

    /// Metres above the zero level at metres from the south-west corner, by the triangle there.
    [[nodiscard]] double heightAt(double x, double y) const;

    [[nodiscard]] dat::BlockCoord blockAt(int bx, int by) const {
        return {southWest_.x + bx, southWest_.y + by};
    }
    /// Adds the LandBlocks; each has a LandBlockInfo.
    void addTo(WorldRecords& records) const;
    /// Those that lie where `isLand` says, counted from the south-west; a LandBlockInfo those that the records have one of.
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
