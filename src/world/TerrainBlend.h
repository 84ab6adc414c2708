#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// Which textures and blend maps paint a landcell (docs/formats/landscape.md#texture-blending), without the textures themselves.
namespace limen::world {

inline constexpr std::uint32_t kRoadType = 0x20;

/// A landcell's corners in the order SW, SE, NE, NW: terrain types 0..31 and road values 0..3.
struct CellCorners {
    std::array<std::uint32_t, 4> terrain{};
    std::array<std::uint32_t, 4> road{};
};

[[nodiscard]] std::uint32_t paletteCode(const CellCorners& corners);

/// One texture laid over others where its code's corners are.
struct BlendLayer {
    std::uint32_t terrainType = 0;
    std::uint32_t code = 0; ///< corner bits: SW 1, SE 2, NE 4, NW 8
};

struct BlendRecipe {
    std::uint32_t base = 0;               ///< terrain type; kRoadType where roads cover everything
    std::vector<BlendLayer> overlays;     ///< at most 3
    std::vector<std::uint32_t> roadCodes; ///< at most 2
};
[[nodiscard]] BlendRecipe blendRecipe(const CellCorners& corners);

/// A blend map and the number of quarter turns that bring it into place.
struct AlphaChoice {
    std::size_t map = 0;
    std::uint32_t rotation = 0;
};
/// Chooses a map for a terrain overlay: by chance among all, then turned; none if it cannot be turned into
/// `code`.
[[nodiscard]] std::optional<AlphaChoice> chooseTerrainMap(std::span<const std::uint32_t> mapCodes,
                                                          std::uint32_t code, std::uint32_t paletteCode);
/// Chooses a map for a road: the first that fits, starting by chance.
[[nodiscard]] std::optional<AlphaChoice> chooseRoadMap(std::span<const std::uint32_t> mapCodes,
                                                       std::uint32_t code, std::uint32_t paletteCode);

} // namespace limen::world
