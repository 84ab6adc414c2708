#include "world/terrain/TerrainBlend.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Quarter turns from code `from` to code `to` (8→1→2→4, 9→3→6→12). No value if there are none.
std::optional<std::uint32_t> turnsBetween(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t turns = 0; turns < 4; ++turns) {
        if (from == to)
            return turns;
        from *= 2;
        if (from >= 16)
            from -= 15;
    }
    return std::nullopt;
}

/// The random first index in a list of `count` maps.
std::size_t startOf(std::uint32_t paletteCode, std::size_t count) {
    const std::uint32_t hash = 1379576222u * paletteCode - 1372186442u;
    const double p = hash * (1.0 / 4294967296.0);
    const auto index = static_cast<std::size_t>(p * static_cast<double>(count));
    return index < count ? index : 0;
}

/// The first corner that shares its type with a later one. If none does: 0, and `pair` is false.
std::size_t baseCorner(const CellCorners& corners, bool& pair) {
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            if (corners.terrain[i] == corners.terrain[j]) {
                pair = true;
                return i;
            }
        }
    }
    pair = false;
    return 0;
}

void addOverlays(const CellCorners& corners, BlendRecipe& recipe) {
    bool pair = false;
    recipe.base = corners.terrain[baseCorner(corners, pair)];
    std::uint32_t found = 0;
    for (std::uint32_t k = 0; k < 4 && (!pair || found < 2); ++k) {
        const std::uint32_t type = corners.terrain[k], bit = 1u << k;
        if (pair ? type == recipe.base : k == 0)
            continue;
        ++found;
        // Two neighbouring corners of one type form a side. Only the second one found can join the first.
        if (pair && found == 2 && recipe.overlays[0].terrainType == type &&
            recipe.overlays[0].code == bit >> 1)
            recipe.overlays[0].code += bit;
        else
            recipe.overlays.push_back({type, bit});
    }
}

void addRoads(const CellCorners& corners, BlendRecipe& recipe) {
    std::uint32_t mask = 0;
    for (std::uint32_t k = 0; k < 4; ++k)
        mask |= corners.road[k] != 0 ? 1u << k : 0u;
    switch (mask) {
    case 0x0:
        break;
    case 0xF:
        recipe = {kRoadType, {}, {}};
        break;
    case 0xE:
        recipe.roadCodes = {6, 12};
        break;
    case 0xD:
        recipe.roadCodes = {9, 12};
        break;
    case 0xB:
        recipe.roadCodes = {9, 3};
        break;
    case 0x7:
        recipe.roadCodes = {3, 6};
        break;
    default:
        recipe.roadCodes = {mask};
    }
}

} // namespace

std::uint32_t paletteCode(const CellCorners& c) {
    return (1u << 28) | (c.road[0] << 26) | (c.road[1] << 24) | (c.road[2] << 22) | (c.road[3] << 20) |
           (c.terrain[0] << 15) | (c.terrain[1] << 10) | (c.terrain[2] << 5) | c.terrain[3];
}

BlendRecipe blendRecipe(const CellCorners& corners) {
    for (const std::uint32_t type : corners.terrain)
        LIMEN_ASSERT(type < 32, "terrain types have five bits");
    BlendRecipe recipe;
    addOverlays(corners, recipe);
    addRoads(corners, recipe);
    LIMEN_ASSERT(recipe.overlays.size() <= 3 && recipe.roadCodes.size() <= 2, "four corners allow no more");
    return recipe;
}

std::optional<AlphaChoice> chooseTerrainMap(std::span<const std::uint32_t> mapCodes, std::uint32_t code,
                                            std::uint32_t palette) {
    if (mapCodes.empty())
        return std::nullopt;
    const std::size_t map = startOf(palette, mapCodes.size());
    if (const std::optional<std::uint32_t> turns = turnsBetween(mapCodes[map], code))
        return AlphaChoice{map, *turns};
    return std::nullopt;
}

std::optional<AlphaChoice> chooseRoadMap(std::span<const std::uint32_t> mapCodes, std::uint32_t code,
                                         std::uint32_t palette) {
    if (mapCodes.empty())
        return std::nullopt;
    const std::size_t start = startOf(palette, mapCodes.size());
    for (std::size_t i = 0; i < mapCodes.size(); ++i) {
        const std::size_t map = (start + i) % mapCodes.size();
        if (const std::optional<std::uint32_t> turns = turnsBetween(mapCodes[map], code))
            return AlphaChoice{map, *turns};
    }
    return std::nullopt;
}

} // namespace limen::world
