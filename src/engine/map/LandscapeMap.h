#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace limen::dat {
class Archive;
}

namespace limen::engine {

/// A picture of the landscape from above: north is up, west is left. It covers the smallest rectangle that
/// holds all landblocks with landscape; in data without landscape, all blocks.
struct LandscapeMap {
    /// The content of a landblock.
    struct Block {
        dat::BlockCoord coord;
        bool hasGround = false;      ///< drawn; else dark
        std::uint32_t buildings = 0; ///< number
        std::uint32_t cells = 0;     ///< number, of buildings and of dungeons
        [[nodiscard]] bool isDungeon() const { return cells > 0 && buildings == 0; }
    };

    int left = 0, bottom = 0;      ///< the south-west landblock
    int columns = 0, rows = 0;     ///< in landblocks; 0: the data has no landblock
    int scale = 8;                 ///< texels along a block's side
    std::vector<std::uint8_t> rgb; ///< sRGB bytes, width() x height(), top row first
    std::vector<Block> blocks;     ///< blocks of the data, ascending by (x, y)
    std::uint32_t damaged = 0;     ///< records that could not be read; their blocks are dark

    [[nodiscard]] std::uint32_t width() const { return static_cast<std::uint32_t>(columns * scale); }
    [[nodiscard]] std::uint32_t height() const { return static_cast<std::uint32_t>(rows * scale); }
    /// The corners of the map, global metres.
    [[nodiscard]] Vec2 southWest() const;
    [[nodiscard]] Vec2 northEast() const;
    /// Texels from the upper left corner of a point in global metres, and back.
    [[nodiscard]] Vec2 texelAt(const Vec2& point) const;
    [[nodiscard]] Vec2 pointAt(const Vec2& texel) const;
    /// Null: the data has no record of this block.
    [[nodiscard]] const Block* find(dat::BlockCoord coord) const;
    /// The colour at a point; none beyond the map.
    [[nodiscard]] std::optional<std::array<std::uint8_t, 3>> colourAt(const Vec2& point) const;
};

inline constexpr int kLeastMapScale = 8, kMostMapScale = 64;
/// The colours of blocks without ground: those that hold nothing, and dungeons.
inline constexpr std::array<std::uint8_t, 3> kNoGround{18, 20, 24};
inline constexpr std::array<std::uint8_t, 3> kDungeonBlock{58, 52, 66};

} // namespace limen::engine
