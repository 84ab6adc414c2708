#include "world/assemble/TerrainAssembler.h"

#include <algorithm>

namespace limen::world {
namespace {

const dat::TerrainTexture* terrainTexture(const dat::Region& region, std::uint32_t type) {
    const auto& textures = region.texMerge.textures;
    const auto found =
        std::find_if(textures.begin(), textures.end(), [&](const auto& t) { return t.terrainType == type; });
    if (found != textures.end())
        return &*found;
    return textures.empty() ? nullptr : &textures.front();
}

std::vector<std::uint32_t> codesOf(const std::vector<dat::AlphaMap>& maps) {
    std::vector<std::uint32_t> codes;
    codes.reserve(maps.size());
    for (const dat::AlphaMap& map : maps)
        codes.push_back(map.code);
    return codes;
}

} // namespace

void TerrainAssembler::add(const JoiningBlock& block) {
    if (!block.content.ground)
        return;
    const dat::RecordId id = dat::landBlockId(block.content.coord);
    const std::uint32_t cells = addCells(*block.content.ground);
    Instance& terrain = addBakedInstance(block, InstanceKind::Terrain, block.content.terrain,
                                         contentKey(MeshSource::Terrain, id), arena_, world_);
    terrain.object = wholeObject(id);
    terrain.record = id;
    terrain.firstMaterial = cells;
}

std::uint32_t TerrainAssembler::addCells(const Ground& ground) {
    const auto first = static_cast<std::uint32_t>(world_.terrainCells.size());
    for (int cell = 0; cell < 64; ++cell) {
        const CellCorners corners = ground.corners(cell / 8, cell % 8);
        const auto [entry, fresh] = painted_.try_emplace(paletteCode(corners));
        if (fresh)
            entry->second = paint(corners);
        world_.terrainCells.push_back(entry->second);
        world_.terrainCells.back().split = splitsSouthWestNorthEast(ground.coord, cell / 8, cell % 8) ? 1 : 0;
    }
    return first;
}

TerrainCell TerrainAssembler::paint(const CellCorners& corners) {
    LIMEN_ASSERT(region_ != nullptr, "blocks have ground only with a Region");
    const dat::TexMerge& merge = region_->texMerge;
    const BlendRecipe recipe = blendRecipe(corners);
    const std::uint32_t palette = paletteCode(corners);
    const auto layer = [&](std::uint32_t type) {
        TerrainCell::Layer out;
        if (const dat::TerrainTexture* texture = terrainTexture(*region_, type)) {
            out.texture = materials_.plainTexture(texture->texture);
            out.tiling = static_cast<float>(std::clamp(texture->tiling, 1u, 1024u));
        }
        return out;
    };
    const auto masked = [&](std::uint32_t type, const std::vector<dat::AlphaMap>& maps,
                            const AlphaChoice& choice) {
        LIMEN_ASSERT(choice.map < maps.size(), "the choice is one of the maps");
        TerrainCell::Layer out = layer(type);
        out.alpha = materials_.plainTexture(maps[choice.map].texture);
        out.rotation = choice.rotation;
        return out;
    };
    TerrainCell cell;
    cell.base = layer(recipe.base);
    std::size_t used = 0;
    for (const BlendLayer& overlay : recipe.overlays) {
        const bool corner = (overlay.code & (overlay.code - 1)) == 0;
        const std::vector<dat::AlphaMap>& maps = corner ? merge.corners : merge.sides;
        if (const auto choice = chooseTerrainMap(codesOf(maps), overlay.code, palette);
            choice && used < cell.overlays.size())
            cell.overlays[used++] = masked(overlay.terrainType, maps, *choice);
    }
    used = 0;
    for (const std::uint32_t code : recipe.roadCodes)
        if (const auto choice = chooseRoadMap(codesOf(merge.roads), code, palette);
            choice && used < cell.roads.size())
            cell.roads[used++] = masked(kRoadType, merge.roads, *choice);
    return cell;
}

} // namespace limen::world
