#include "viewer/inspect/ResidencyMap.h"

#include "core/Assert.h"
#include "world/Loader.h"

#include <algorithm>

namespace limen::viewer {
namespace {

/// Counts the cells and portals of every block, in the order of World::blocks.
std::vector<ResidentBlock> factsOf(const world::World& world) {
    std::vector<ResidentBlock> blocks;
    for (const world::Block& block : world.blocks)
        blocks.push_back(
            {.coord = block.coord, .state = ResidentBlock::State::Loaded, .hasTerrain = block.hasTerrain});
    for (const world::Space& space : world.spaces)
        if (space.block < blocks.size())
            ++blocks[space.block].cells;
    for (const world::Portal& portal : world.portals)
        if (portal.space == world::kOutside && portal.block < blocks.size())
            ++blocks[portal.block].buildingPortals;
    return blocks;
}

} // namespace

ResidencyMap residencyMap(const world::World& world, dat::BlockCoord eye, dat::BlockCoord player,
                          int radius) {
    LIMEN_ASSERT(radius >= 0, "a radius is not negative");
    ResidencyMap map;
    map.side = 2 * radius + 1;
    for (int row = 0; row < map.side; ++row) {
        for (int column = 0; column < map.side; ++column) {
            ResidentBlock block;
            block.coord = {eye.x - radius + column, eye.y + radius - row};
            map.blocks.push_back(block);
        }
    }
    for (const ResidentBlock& block : factsOf(world)) {
        ++map.loaded;
        map.terrains += block.hasTerrain ? 1u : 0u;
        map.cells += block.cells;
        map.buildingPortals += block.buildingPortals;
        const int column = block.coord.x - eye.x + radius, row = eye.y + radius - block.coord.y;
        if (column >= 0 && column < map.side && row >= 0 && row < map.side)
            map.blocks[static_cast<std::size_t>(row * map.side + column)] = block;
    }
    for (ResidentBlock& block : map.blocks) {
        block.holdsEye = block.coord == eye;
        block.holdsPlayer = block.coord == player;
    }
    return map;
}

dat::BlockCoord blockOf(const world::World& world, world::SpaceIndex space, const Vec3& at) {
    return space == world::kOutside ? world::blockAt(at) : dat::blockOf(world.spaces[space].cellId);
}

} // namespace limen::viewer
