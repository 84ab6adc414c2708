#include "world/assemble/StructureAssembler.h"

namespace limen::world {

void StructureAssembler::add(const JoiningBlock& block) {
    addExteriors(block);
    addShells(block);
}

void StructureAssembler::addExteriors(const JoiningBlock& block) {
    std::uint32_t index = 0;
    for (const ExteriorContent& exterior : block.content.exteriors) {
        const std::uint32_t materials = materials_.add(exterior.surfaces, exterior.clamp);
        const std::uint64_t key =
            contentKey(MeshSource::Exterior, dat::landBlockInfoId(block.content.coord), index++);
        Instance& instance =
            addBakedInstance(block, InstanceKind::Exterior, exterior.mesh, key, arena_, world_);
        instance.object = exterior.object;
        instance.record = exterior.gfxObj;
        instance.firstMaterial = materials;
    }
}

void StructureAssembler::addShells(const JoiningBlock& block) {
    for (std::uint32_t i = 0; i < block.content.cells.size(); ++i) {
        const CellContent& cell = block.content.cells[i];
        Space& space = world_.spaces[block.spaceOf(i)];
        LIMEN_ASSERT(space.cellId == cell.id && space.shell == kNone,
                     "the space of this cell, without a shell");
        const std::uint32_t materials = materials_.add(cell.surfaces, cell.clamp);
        Instance& shell = addBakedInstance(block, InstanceKind::Shell, cell.shell,
                                           contentKey(MeshSource::Shell, cell.id), arena_, world_);
        shell.object = wholeObject(cell.id);
        shell.record = cell.id;
        shell.firstMaterial = materials;
        shell.placedIn = block.spaceOf(i);
        if (world_.zones[space.zone].spaceCount > 1)
            arena_.setNeighbours(shell.mesh, cell.shell.inOpenings);
        space.shell = static_cast<InstanceIndex>(world_.instances.size() - 1);
    }
}

} // namespace limen::world
