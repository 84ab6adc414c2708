#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// The choice of textures and blend maps for a landcell, without the textures themselves.
// docs/formats/landscape.md#texture-blending.
namespace limen::world {

inline constexpr std::uint32_t kRoadType = 0x20;

/// A landcell's corners in the order SW, SE, NE, NW: terrain types 0..31 and road values 0..3.
struct CellCorners {
    std::array<std::uint32_t, 4> terrain{};
    std::array<std::uint32_t, 4> road{};
};

[[nodiscard]] std::uint32_t paletteCode(const CellCorners& corners);

/// One texture that is blended over others at the corners in its code.
struct BlendLayer {
    std::uint32_t terrainType = 0;
    std::uint32_t code = 0; ///< corner bits: SW 1, SE 2, NE 4, NW 8
};

struct BlendRecipe {
    std::uint32_t base = 0;               ///< terrain type; kRoadType if roads cover the landcell
    std::vector<BlendLayer> overlays;     ///< at most 3
    std::vector<std::uint32_t> roadCodes; ///< at most 2
};
[[nodiscard]] BlendRecipe blendRecipe(const CellCorners& corners);

/// A blend map and the quarter turns to rotate it by.
struct AlphaChoice {
    std::size_t map = 0;
    std::uint32_t rotation = 0;
};
/// Chooses a map for a terrain overlay: at random among all, then rotated to `code`. No value if no rotation
/// fits.
[[nodiscard]] std::optional<AlphaChoice> chooseTerrainMap(std::span<const std::uint32_t> mapCodes,
                                                          std::uint32_t code, std::uint32_t paletteCode);
/// Chooses a map for a road: the first that fits, starting at a random one.
[[nodiscard]] std::optional<AlphaChoice> chooseRoadMap(std::span<const std::uint32_t> mapCodes,
                                                       std::uint32_t code, std::uint32_t paletteCode);

} // namespace limen::world
